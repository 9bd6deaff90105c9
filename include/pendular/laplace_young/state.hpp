// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/laplace_young/equations.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pendular::laplace_young {

/// A liquid bridge between two spheres, or between a sphere and a plane, whose radius is then infinite.
struct liquid_bridge {
  double radius_i;         // m
  double radius_j;         // m; at most one of the two infinite
  double contact_angle;    // rad, in [0, pi/2)
  double volume;           // m3
  double surface_tension;  // N/m
};

/// A bridge in equilibrium. All that changes sign does so by what the liquid does: it pulls with a positive force.
struct state {
  double gap;               // m
  double attraction;        // N; negative if the bridge pushes
  double suction;           // pressure of the gas less that of the liquid, Pa
  double mean_curvature;    // suction / (2 gamma), 1/m
  double filling_angle_i;   // from the axis to the contact line, rad; 0 on a plane
  double filling_angle_j;   // rad
  double contact_radius_i;  // of the contact line, m
  double contact_radius_j;  // m
  double neck_radius;       // smallest radius of the liquid surface, m
  double wetted_area_i;     // m2
  double wetted_area_j;     // m2
  double free_area;         // of the liquid surface, m2
  double volume;            // m3
  double energy;            // gamma (free - cos(theta) wetted), J; its slope along the gap at fixed volume is the force
};

namespace detail {
/// The unit of length of a bridge: its smaller radius.
inline double unit_of(const liquid_bridge& b) { return std::min(b.radius_i, b.radius_j); }
}  // namespace detail

inline void validate(const liquid_bridge& b) {
  constexpr auto page = "docs/reference/laplace_young.md";
  for (const double radius : {b.radius_i, b.radius_j}) {
    expects(radius > 0, "the radius of a body of a bridge (m)", radius, "positive, or infinite for a plane", page);
  }
  expects_positive("the smaller radius of a bridge (m)", detail::unit_of(b), page);
  expects(b.contact_angle >= 0 && b.contact_angle < std::numbers::pi / 2, "the contact angle (rad)", b.contact_angle,
          "in [0, pi/2)", page);
  const double unit = detail::unit_of(b);
  expects(b.volume >= 1e-14 * unit * unit * unit && b.volume <= 10 * unit * unit * unit, "the volume of a bridge (m3)",
          b.volume, "1e-14 to 10 times the cube of the smaller radius", page);
  expects_positive("the surface tension (N/m)", b.surface_tension, page);
}

namespace detail {

inline geometry<double> geometry_of(const liquid_bridge& b) {
  const double unit = unit_of(b);
  // Nearer than this the turn of the branch next to the symmetric one is too sharp to be followed.
  if (std::abs(b.radius_i - b.radius_j) < 1e-9 * unit) return {1, 1, b.contact_angle};
  return {unit / b.radius_i, unit / b.radius_j, b.contact_angle};
}

inline std::array<double, places> numbers_of(const vector6& z) { return {z[0], z[1], z[2], z[3], z[4], z[5]}; }

inline state state_of(const liquid_bridge& b, const vector6& z) {
  const geometry<double> g = geometry_of(b);
  const auto x = numbers_of(z);
  const meridian<double> m = meridian_of(g, x);
  const auto first = cap_of(std::exp(z[log_arc_i]), g.curvature_i);
  const auto second = cap_of(std::exp(z[log_arc_j]), g.curvature_j);
  const auto sum = m.integrate();
  const double unit = unit_of(b), area = unit * unit;
  const double wetted = first.area + second.area;
  return {z[gap] * unit,
          2 * std::numbers::pi * b.surface_tension * unit * m.force,
          b.surface_tension * m.curvature() / unit,
          m.curvature() / (2 * unit),
          first.slope,
          second.slope,
          first.radius * unit,
          second.radius * unit,
          m.neck() * unit,
          first.area * area,
          second.area * area,
          sum.area * area,
          (sum.volume - first.volume - second.volume) * area * unit,
          b.surface_tension * area * (sum.area - std::cos(b.contact_angle) * wetted)};
}

}  // namespace detail
}  // namespace pendular::laplace_young
