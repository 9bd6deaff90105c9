// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/observe/pairs.hpp>
#include <pendular/space/grains.hpp>

#include <cstddef>
#include <numbers>
#include <vector>

namespace pendular::observe {

namespace detail {
/// The lever arm ends in the middle of the gap, as in the contact laws: the two arms of a pair add up to its branch.
template <class System>
void add_pair_moments(const System& s, std::vector<double>& moment) {
  for (const pair& p : pairs(s)) {
    const double push = p.push();
    moment[p.rows.first] += push * (p.radius_i + 0.5 * p.gap);
    moment[p.rows.second] += push * (p.radius_j + 0.5 * p.gap);
  }
}

/// At a wall the lever arm ends on the wall.
template <class System>
void add_wall_moments(const System& s, std::vector<double>& moment) {
  const auto position = s.particles().template get<column::position>();
  const auto radius = s.particles().template get<column::radius>();
  s.for_each_wall([&](const auto& wall, const auto& contacts) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const std::size_t row = contacts.row(k);
      const vector normal = wall.shape.meet(position[row], radius[row]).normal;
      moment[row] -= dot(contacts.force(k), normal) * (radius[row] + contacts.gap(k));
    }
  });
}
}  // namespace detail

/// Pressure of every grain, Pa, in the order of ids, compression positive: a third of the trace of its internal moment
/// over its volume, that of the sphere over the solid fraction of the packing. Pairs, bridges and walls count.
/// Source: Richefeu et al. 2006 (Eur. Phys. J. E 21, 359), section 5. Errors: solid fraction not in (0, 1].
template <class System>
std::vector<double> grain_pressures(const System& s, double solid_fraction = 1) {
  expects(solid_fraction > 0 && solid_fraction <= 1, "the solid fraction", solid_fraction, "in (0, 1]",
          "docs/reference/observe.md");
  std::vector<double> moment(s.particles().size(), 0.0);  // by row, N m
  detail::add_pair_moments(s, moment);
  detail::add_wall_moments(s, moment);
  const auto radius = s.particles().template get<column::radius>();
  std::vector<double> pressure;
  pressure.reserve(moment.size());
  for (const std::size_t row : s.particles().rows_by_id()) {
    const double three_volumes = 4 * std::numbers::pi * radius[row] * radius[row] * radius[row];
    pressure.push_back(solid_fraction * moment[row] / three_volumes);
  }
  return pressure;
}

}  // namespace pendular::observe
