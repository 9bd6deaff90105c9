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

/// That of no points is the origin.
inline box bounding_box(strided<const vector> positions) {
  if (positions.empty()) return {{0, 0, 0}, {0, 0, 0}};
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
    std::vector<std::size_t> start(cell_count() + 1, 0);
    for (const auto cell : cell_of_) ++start[cell + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    return start;
  }

  std::size_t cell_count() const { return static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]); }

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

  /// The same for the cells that a ball around any point may meet, in the grid or not.
  template <class Visit>
  void for_ball(const vector& p, double radius, const Visit& visit) const {
    if (is_apart(p, radius)) return;
    const double r = radius + slack * edge_;
    const vector o = p - box_.lower;
    const auto first_y = along(o.y - r, 1), last_y = along(o.y + r, 1);
    const auto first_z = along(o.z - r, 2), last_z = along(o.z + r, 2);
    for (auto k = first_z; k <= last_z; ++k) {
      const double z = to_layer(o.z, k);
      for (auto j = first_y; j <= last_y; ++j) {
        const double y = to_layer(o.y, j), square = r * r - y * y - z * z;
        if (square < 0) continue;
        const double half = std::sqrt(square);
        const auto begin = line(j, k) * counts_[0];
        visit(static_cast<std::size_t>(begin + along(o.x - half, 0)),
              static_cast<std::size_t>(begin + along(o.x + half, 0)));
      }
    }
  }

  /// About how many rows of cells and how many cells such a ball meets at most.
  std::array<double, 2> cells_in_ball(double radius) const {
    std::array<double, 3> met{};
    for (std::size_t k = 0; k < 3; ++k) met[k] = std::min(static_cast<double>(counts_[k]), 2 * radius / edge_ + 1);
    return {met[1] * met[2], met[0] * met[1] * met[2]};
  }

 private:
  static constexpr double slack = 1e-6;  // in edges, for what rounding makes of the borders of cells

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
    return static_cast<std::int64_t>(std::clamp(offset / edge_, 0.0, static_cast<double>(counts_[axis] - 1)));
  }

  /// How far an offset is from a layer of cells, m.
  double to_layer(double offset, std::int64_t layer) const {
    const double begin = static_cast<double>(layer) * edge_;
    return std::max({begin - offset, offset - begin - edge_, 0.0});
  }

  bool is_apart(const vector& p, double distance) const {
    const double d = distance + slack * edge_;
    return p.x + d < box_.lower.x || p.x - d > box_.upper.x || p.y + d < box_.lower.y || p.y - d > box_.upper.y ||
           p.z + d < box_.lower.z || p.z - d > box_.upper.z;
  }

  box box_;
  double edge_ = 0;
  std::array<std::int64_t, 3> counts_{1, 1, 1};
  std::vector<std::size_t> cell_of_;
};

}  // namespace pendular
