// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/space/cell_grid.hpp>

#include <algorithm>
#include <set>
#include <vector>

using namespace pendular;

namespace {
std::vector<std::int64_t> numbered(std::size_t count) {
  std::vector<std::int64_t> ids(count);
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}
}  // namespace

TEST_CASE("the bounding box holds all points") {
  const std::vector<vector> points{{1, -2, 3}, {0, 5, 3}, {-4, 0, 9}};
  const box b = bounding_box(points);
  CHECK(b.lower == vector{-4, -2, 3});
  CHECK(b.upper == vector{1, 5, 9});
}

TEST_CASE("points are sorted by cell, x fastest, and by id within a cell") {
  // Cells of edge 1 from (0, 0, 0): cells 0, 1, 1 (x), 4 = 2 in y of 2, ...
  const std::vector<vector> points{{1.5, 1.5, 0}, {0.2, 0, 0}, {1.1, 0, 0}, {1.9, 0.9, 0}, {0.1, 1.2, 0}, {0, 0, 0}};
  const cell_grid grid(points, 1);
  CHECK(grid.cell_at({0.5, 0.5, 0}) == 0);
  CHECK(grid.cell_at({1.5, 0.5, 0}) == 1);
  CHECK(grid.cell_at({0.5, 1.2, 0}) == 2);
  CHECK(grid.order(numbered(6)) == std::vector<std::size_t>{1, 5, 2, 3, 4, 0});
  const std::vector<std::int64_t> reversed{5, 4, 3, 2, 1, 0};
  CHECK(grid.order(reversed) == std::vector<std::size_t>{5, 1, 3, 2, 4, 0});
  CHECK(grid.starts() == std::vector<std::size_t>{0, 2, 4, 5, 6});
}

TEST_CASE("points outside of the box fall into the cells of its rim") {
  const cell_grid grid(std::vector<vector>{{0, 0, 0}, {3.5, 0, 0}}, 1);
  CHECK(grid.cell_at({-7, 0, 0}) == 0);
  CHECK(grid.cell_at({99, 0, 0}) == 3);
  CHECK(grid.cell_at({2.5, -5, 8}) == 2);
}

TEST_CASE("the order is a permutation and neighbouring cells hold every point nearer than an edge") {
  std::vector<vector> points;
  for (int k = 0; k < 500; ++k) points.push_back({(k * 37) % 101 * 0.1, (k * 53) % 97 * 0.1, (k * 71) % 89 * 0.1});
  const cell_grid unsorted(points, 1.3);
  const auto order = unsorted.order(numbered(500));
  CHECK(std::set<std::size_t>(order.begin(), order.end()).size() == 500);
  std::vector<vector> stored;
  for (const std::size_t row : order) stored.push_back(points[row]);
  const cell_grid grid(stored, 1.3);
  const auto starts = grid.starts();
  CHECK(starts.back() == 500);
  for (std::size_t a = 0; a < 500; a += 7) {
    std::set<std::size_t> seen;
    grid.for_neighbours(stored[a], [&](std::size_t from, std::size_t to) {
      for (std::size_t b = starts[from]; b < starts[to + 1]; ++b) CHECK(seen.insert(b).second);
    });
    for (std::size_t b = 0; b < 500; ++b) {
      const vector d = stored[b] - stored[a];
      if (dot(d, d) < 1.3 * 1.3) CHECK(seen.count(b) == 1);
    }
    CHECK(seen.size() < 500);
  }
}

TEST_CASE("the number of cells is bounded by the number of points, however far they are apart") {
  for (const double far : {1e2, 1e6, 1e12, 1e100}) {
    const std::vector<vector> points{{0, 0, 0}, {1, 1, 1}, {far, far, -far}};
    CHECK(cell_grid(points, 1e-3).starts().size() <= 4 * 3 + 64 + 1);
  }
}
