// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/strided.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/space/cell_grid.hpp>
#include <pendular/space/size_classes.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pendular {

/// Cells for grains of any grading: every size class has a grid of its own, with cells as large as its grains ask for. Rows
/// stand class by class, the largest grains first, by cell within a class and by id within a cell. Copies of grains of other
/// parts of a scene are a class of their own behind all others, and no pairs of two copies come up. Memory is proportional
/// to the number of grains.
class graded_grid {
 public:
  /// For pairs of grains whose gap is `range` at most, m; rows from `kept` on are copies.
  graded_grid(strided<const vector> positions, strided<const double> radii, double range, std::size_t kept)
      : classes_(radii, range, kept), first_row_{0} {
    for (const auto& c : classes_.all()) {
      levels_.push_back(make_level(positions, c, first_row_.back()));
      first_row_.push_back(first_row_.back() + c.rows.size());
    }
    for (std::size_t a = 0; a < levels_.size(); ++a) {
      for (std::size_t b = a + 1; b < levels_.size(); ++b) {
        if (classes_.all()[a].are_copies) continue;
        const bool large_looks = cost(a, b) < cost(b, a);
        levels_[large_looks ? a : b].looks_into.push_back(large_looks ? b : a);
      }
    }
  }

  graded_grid(strided<const vector> positions, strided<const double> radii, double range)
      : graded_grid(positions, radii, range, radii.size()) {}

  /// Row k becomes what was row order[k].
  std::vector<std::size_t> order(std::span<const std::int64_t> ids) const {
    if (levels_.size() == 1) return levels_[0].cells.order(ids);
    std::vector<std::size_t> all;
    all.reserve(first_row_.back());
    std::vector<std::int64_t> keys;
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      const auto& rows = classes_.all()[k].rows;
      keys.clear();
      for (const std::size_t row : rows) keys.push_back(ids[row]);
      for (const std::size_t at : levels_[k].cells.order(keys)) all.push_back(rows[at]);
    }
    return all;
  }

  /// visit(first row, end) for stretches of rows that hold the partners of a row, once the rows are stored in that order.
  /// Over all rows every pair comes up once.
  template <class Visit>
  void for_candidates(std::size_t row, const vector& position, double radius, const Visit& visit) const {
    const auto above = std::upper_bound(first_row_.begin(), first_row_.end(), row);
    const level& own = levels_[static_cast<std::size_t>(above - first_row_.begin()) - 1];
    if (row < classes_.kept()) {
      own.cells.for_neighbours(position, [&](std::size_t first, std::size_t last) {
        visit(std::max(own.starts[first], row + 1), own.starts[last + 1]);
      });
    }
    for (const std::size_t k : own.looks_into) {
      const level& other = levels_[k];
      other.cells.for_ball(
          position, classes_.halo(radius) + classes_.all()[k].halo,
          [&](std::size_t first, std::size_t last) { visit(other.starts[first], other.starts[last + 1]); });
    }
  }

 private:
  struct level {
    cell_grid cells;
    std::vector<std::size_t> starts;
    std::vector<std::size_t> looks_into;  // levels in which grains of this one look for partners
  };

  static cell_grid cells_of(strided<const vector> positions, const size_classes::size_class& c) {
    if (c.rows.size() == positions.size()) return cell_grid(positions, 2 * c.halo);
    std::vector<vector> points;
    points.reserve(c.rows.size());
    for (const std::size_t row : c.rows) points.push_back(positions[row]);
    return cell_grid(points, 2 * c.halo);
  }

  static level make_level(strided<const vector> positions, const size_classes::size_class& c, std::size_t first_row) {
    level made{cells_of(positions, c), {}, {}};
    made.starts = made.cells.starts();
    for (std::size_t& start : made.starts) start += first_row;
    return made;
  }

  /// About what it costs if all grains of one level look for their partners in another: rows of cells and grains seen.
  double cost(std::size_t from, std::size_t into) const {
    const auto& classes = classes_.all();
    const cell_grid& cells = levels_[into].cells;
    const auto [lines, met] = cells.cells_in_ball(classes[from].halo + classes[into].halo);
    const double per_cell = static_cast<double>(classes[into].rows.size()) / static_cast<double>(cells.cell_count());
    return static_cast<double>(classes[from].rows.size()) * (search_cost::line * lines + met * per_cell);
  }

  size_classes classes_;
  std::vector<std::size_t> first_row_;  // of every level, and the end
  std::vector<level> levels_;
};

}  // namespace pendular
