// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/space/cell_grid.hpp>

#include <algorithm>
#include <cmath>
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

TEST_CASE("no points have a box in the origin and a grid of one empty cell") {
  const box b = bounding_box(std::vector<vector>{});
  CHECK((b.lower == vector{0, 0, 0} && b.upper == vector{0, 0, 0}));
  const cell_grid grid(std::vector<vector>{}, 1);
  CHECK(grid.order({}).empty());
  CHECK(grid.starts() == std::vector<std::size_t>{0, 0});
  std::size_t visits = 0;
  grid.for_neighbours({7, -7, 7}, [&](std::size_t from, std::size_t to) { visits += from == 0 && to == 0; });
  CHECK(visits == 1);
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
  CHECK(grid.cell_at({1e200, 0, 0}) == 3);
  CHECK(grid.cell_at({-1e200, 1e200, 0}) == 0);
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

TEST_CASE("a ball meets the cells of all points in it, each once, and few others") {
  std::vector<vector> points;
  for (int k = 0; k < 3000; ++k) points.push_back({(k * 37) % 101 * 0.1, (k * 53) % 97 * 0.1, (k * 71) % 89 * 0.1});
  const cell_grid unsorted(points, 0.9);
  std::vector<vector> stored;
  for (const std::size_t row : unsorted.order(numbered(3000))) stored.push_back(points[row]);
  const cell_grid grid(stored, 0.9);
  const auto starts = grid.starts();
  for (const vector& centre : {vector{5, 5, 5}, vector{-2, 5, 4}, vector{12, 11, -1}, vector{5, 4, 3.6}}) {
    for (const double radius : {0.0, 0.4, 2.7, 4.0, 9.0, 30.0}) {
      std::set<std::size_t> seen;
      grid.for_ball(centre, radius, [&](std::size_t from, std::size_t to) {
        for (std::size_t b = starts[from]; b < starts[to + 1]; ++b) REQUIRE(seen.insert(b).second);
      });
      std::size_t near = 0;
      for (std::size_t b = 0; b < 3000; ++b) {
        const double distance = norm(stored[b] - centre);
        if (distance <= radius) REQUIRE(seen.count(b) == 1);
        near += distance <= radius + 1.001 * 0.9 * std::sqrt(3.0);  // a diagonal of a cell
      }
      CHECK(seen.size() <= near);
    }
  }
}

TEST_CASE("a ball that is apart from all points meets no cell") {
  const cell_grid grid(std::vector<vector>{{0, 0, 0}, {1, 1, 1}}, 0.5);
  for (const vector& centre : {vector{-3, 0, 0}, vector{0, 4, 0}, vector{0, 0, 1e200}, vector{-1e200, 0, 0}}) {
    grid.for_ball(centre, 2.5, [](std::size_t, std::size_t) { FAIL("a cell was met"); });
  }
}

TEST_CASE("the number of cells is bounded by the number of points, however far they are apart") {
  for (const double far : {1e2, 1e6, 1e12, 1e100}) {
    const std::vector<vector> points{{0, 0, 0}, {1, 1, 1}, {far, far, -far}};
    CHECK(cell_grid(points, 1e-3).starts().size() <= 4 * 3 + 64 + 1);
  }
}
