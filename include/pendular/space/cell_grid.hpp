// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/strided.hpp>
#include <pendular/core/vec.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace pendular {

/// Axis-aligned box, m.
struct box {
  vector lower, upper;
};

inline box bounding_box(strided<const vector> positions) {
  box b{positions[0], positions[0]};
  for (const vector& p : positions) {
    b.lower = {std::min(b.lower.x, p.x), std::min(b.lower.y, p.y), std::min(b.lower.z, p.z)};
    b.upper = {std::max(b.upper.x, p.x), std::max(b.upper.y, p.y), std::max(b.upper.z, p.z)};
  }
  return b;
}

/// Cells of at least the given edge over the box of the points, each with the rows of its points.
class cell_grid {
 public:
  cell_grid(strided<const vector> positions, double edge) : box_(bounding_box(positions)) {
    choose_cells(positions.size(), edge);
    cell_of_.resize(positions.size());
    for (std::size_t row = 0; row < positions.size(); ++row) cell_of_[row] = cell_at(positions[row]);
  }

  /// Rows sorted by cell; rows of one cell keep the order of their keys.
  std::vector<std::size_t> order(std::span<const std::int64_t> keys) const {
    std::vector<std::size_t> rows(cell_of_.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
      return cell_of_[a] != cell_of_[b] ? cell_of_[a] < cell_of_[b] : keys[a] < keys[b];
    });
    return rows;
  }

  /// Start of every cell once the rows are stored in that order; one more entry than cells.
  std::vector<std::size_t> starts() const {
    std::vector<std::size_t> start(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]) + 1, 0);
    for (const auto cell : cell_of_) ++start[cell + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    return start;
  }

  std::size_t cell_at(const vector& p) const {
    const auto x = along(p.x - box_.lower.x, 0), y = along(p.y - box_.lower.y, 1), z = along(p.z - box_.lower.z, 2);
    return static_cast<std::size_t>(line(y, z) * counts_[0] + x);
  }

  /// visit(first cell, last cell) for every row of neighbouring cells along x, the point's own cell included.
  template <class Visit>
  void for_neighbours(const vector& p, const Visit& visit) const {
    const auto x = along(p.x - box_.lower.x, 0), y = along(p.y - box_.lower.y, 1), z = along(p.z - box_.lower.z, 2);
    for (auto k = std::max<std::int64_t>(z - 1, 0); k <= std::min(z + 1, counts_[2] - 1); ++k) {
      for (auto j = std::max<std::int64_t>(y - 1, 0); j <= std::min(y + 1, counts_[1] - 1); ++j) {
        const auto begin = line(j, k) * counts_[0];
        visit(static_cast<std::size_t>(begin + std::max<std::int64_t>(x - 1, 0)),
              static_cast<std::size_t>(begin + std::min(x + 1, counts_[0] - 1)));
      }
    }
  }

 private:
  void choose_cells(std::size_t points, double edge) {
    const std::array<double, 3> extent{box_.upper.x - box_.lower.x, box_.upper.y - box_.lower.y,
                                       box_.upper.z - box_.lower.z};
    const double most_cells = 4.0 * static_cast<double>(points) + 64.0;  // a far grain must not ask for much memory
    for (edge_ = edge;; edge_ *= 1.5) {
      double cells = 1;
      for (std::size_t k = 0; k < 3; ++k) cells *= std::floor(extent[k] / edge_) + 1;
      if (!(cells > most_cells)) break;  // also if the edge is no number
    }
    for (std::size_t k = 0; k < 3; ++k) counts_[k] = static_cast<std::int64_t>(extent[k] / edge_) + 1;
  }

  std::int64_t line(std::int64_t y, std::int64_t z) const { return z * counts_[1] + y; }

  std::int64_t along(double offset, std::size_t axis) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(offset / edge_), 0, counts_[axis] - 1);
  }

  box box_;
  double edge_ = 0;
  std::array<std::int64_t, 3> counts_{1, 1, 1};
  std::vector<std::size_t> cell_of_;
};

}  // namespace pendular
