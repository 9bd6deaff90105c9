// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/strided.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/liquid/protocol/concepts.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pendular {

/// Gaps of all rows of the bonds in this step and in the one before, m.
struct gap_history {
  std::span<const double> now;
  std::span<const double> before;
};

/// A grain near a wall that carries bridges.
struct wall_row {
  std::int32_t grain;  // its row
  std::int32_t wall;   // its place among the walls of the scene; -1 for padding
  double gap;          // m
  vector normal;       // from the grain to the wall
};

/// Read-only look at the listed pairs and their grains, as the liquid needs it: row p of the bonds is pair p of the
/// list, and after the padded list come the grains near the walls that carry bridges, wall by wall, padded.
struct pair_view {
  std::span<const std::int32_t> first, second;  // rows of the grains, padded
  std::size_t pairs;                            // without padding
  strided<const vector> position;               // m
  strided<const double> radius;                 // m
  std::span<const std::int64_t> id;
  vector up;         // unit vector against gravity, or 0
  std::size_t kept;  // rows of grains before this one are kept here, the others are copies
  bool wet_walls = false;
  std::vector<wall_row> at_walls = {};        // by wall, then by the grain's id
  std::vector<std::size_t> wall_begins = {};  // where each of these walls begins in at_walls

  std::size_t rows() const { return first.size() + at_walls.size(); }
  bool is_at_wall(std::size_t p) const { return p >= first.size(); }
  const wall_row& wall(std::size_t p) const { return at_walls[p - first.size()]; }
  bool keeps(std::size_t grain) const { return grain < kept; }
  /// Whether a row is counted on this part of the scene, where others have it too.
  bool counts_here(std::size_t p) const { return keeps(grain_i(p)); }
  bool is_padding(std::size_t p) const { return is_at_wall(p) ? wall(p).wall < 0 : p >= pairs; }

  /// visit(row) for all rows that are not padding.
  template <class Visit>
  void for_each_row(const Visit& visit) const {
    for (std::size_t p = 0; p < pairs; ++p) visit(p);
    for (std::size_t p = first.size(); p < rows(); ++p) {
      if (!is_padding(p)) visit(p);
    }
  }

  /// visit(row) for the walls of one grain.
  template <class Visit>
  void for_each_wall_row_of(std::size_t grain, const Visit& visit) const {
    const auto before = [&](const wall_row& w, std::int64_t wanted) {
      return id[static_cast<std::size_t>(w.grain)] < wanted;
    };
    for (std::size_t k = 0; k < wall_begins.size(); ++k) {
      const std::size_t end = k + 1 < wall_begins.size() ? wall_begins[k + 1] : at_walls.size();
      const auto from = at_walls.begin() + static_cast<std::ptrdiff_t>(wall_begins[k]);
      const auto to = at_walls.begin() + static_cast<std::ptrdiff_t>(end);
      const auto found = std::lower_bound(from, to, id[grain], before);
      if (found == to || static_cast<std::size_t>(found->grain) != grain) continue;
      visit(first.size() + static_cast<std::size_t>(found - at_walls.begin()));
    }
  }

  std::size_t grain_i(std::size_t p) const {
    return static_cast<std::size_t>(is_at_wall(p) ? wall(p).grain : first[p]);
  }
  /// Only for a row of two grains.
  std::size_t grain_j(std::size_t p) const { return static_cast<std::size_t>(second[p]); }

  /// visit(grain) for the grains of a row, which are two, or one at a wall.
  template <class Visit>
  void for_each_grain_of(std::size_t p, const Visit& visit) const {
    visit(grain_i(p));
    if (!is_at_wall(p)) visit(grain_j(p));
  }

  /// Sum of a number over the grains of a row.
  double sum_over_grains_of(std::size_t p, strided<const double> of_grain) const {
    return is_at_wall(p) ? of_grain[grain_i(p)] : of_grain[grain_i(p)] + of_grain[grain_j(p)];
  }

  /// Wall k has the id -1 - k.
  std::pair<std::int64_t, std::int64_t> ids(std::size_t p) const {
    return {id[grain_i(p)], is_at_wall(p) ? -1 - std::int64_t{wall(p).wall} : id[grain_j(p)]};
  }
  /// Puts rows into the order of these ids.
  void sort_by_ids(std::vector<std::size_t>& rows) const {
    std::sort(rows.begin(), rows.end(), [this](std::size_t p, std::size_t q) { return ids(p) < ids(q); });
  }

  double gap(std::size_t p) const {
    if (is_at_wall(p)) return wall(p).gap;
    const vector d = position[grain_j(p)] - position[grain_i(p)];
    return norm(d) - radius[grain_i(p)] - radius[grain_j(p)];
  }

  bridge<double> bridge_of(std::size_t p, double gap, double volume) const {
    const double radius_i = radius[grain_i(p)];
    return {gap, volume, radius_i, is_at_wall(p) ? wall_radius(radius_i) : radius[grain_j(p)]};
  }

  /// The row as grain `own` of it sees it; to the protocols a wall is a partner of the grain's own size.
  bond_side side(std::size_t p, std::size_t own, bool forming) const {
    if (is_at_wall(p)) {
      const double height = (radius[own] + wall(p).gap) * dot(wall(p).normal, up);
      return {radius[own], radius[own], height, ids(p).second, forming};
    }
    const std::size_t partner = own == grain_i(p) ? grain_j(p) : grain_i(p);
    const vector d = position[partner] - position[own];
    const double distance = norm(d);
    const double lever = 0.5 * (distance + radius[own] - radius[partner]);
    return {radius[own], radius[partner], lever / distance * dot(d, up), id[partner], forming};
  }
};

}  // namespace pendular
