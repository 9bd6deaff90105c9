// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/observe/circle_overlap.hpp>
#include <pendular/space/grains.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pendular::observe {

/// Where a solid fraction is measured: a cylinder about the z axis.
struct upright_cylinder {
  double radius;     // m
  double low, high;  // its ends, m

  /// m3; 0 if there is nothing between the ends.
  double volume() const { return radius > 0 && high > low ? std::numbers::pi * radius * radius * (high - low) : 0; }
};

/// Volume of a sphere inside of the cylinder, m3: exact for a sphere that is wholly in or out, to 3e-4 of its volume
/// for one that is cut by a cylinder as wide as the sphere or wider, to 3e-3 by a narrower one.
inline double volume_within(const vector& centre, double radius, const upright_cylinder& c) {
  if (c.volume() == 0) return 0;
  const double from_axis = std::hypot(centre.x, centre.y);
  const double low = std::clamp((c.low - centre.z) / radius, -1.0, 1.0);
  const double high = std::clamp((c.high - centre.z) / radius, -1.0, 1.0);
  if (low == high || from_axis >= c.radius + radius) return 0;
  if (low == -1 && high == 1 && from_axis + radius <= c.radius) {
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  }
  // Layer by layer; the height is R sin(t), which takes the roots at both poles away.
  const auto layer = [&](double t) {
    return circle_overlap(radius * std::cos(t), c.radius, from_axis) * radius * std::cos(t);
  };
  return boost::math::quadrature::gauss<double, 30>::integrate(layer, std::asin(low), std::asin(high));
}

/// Solid fraction inside of the cylinder, in which grains count with the part of them that is there; 0 for a cylinder
/// without volume.
template <class Grains>
double solid_fraction_within(const Grains& g, const upright_cylinder& c) {
  const auto position = g.template get<column::position>();
  const auto radius = g.template get<column::radius>();
  double solid = 0;
  for (const std::size_t row : g.rows_by_id()) solid += volume_within(position[row], radius[row], c);
  return c.volume() > 0 ? solid / c.volume() : 0;
}

/// Solid fractions of a sample in a cell whose walls keep grains apart from a dense packing.
struct solid_fractions {
  double cell = 0;        // over all of the cell
  double bulk = 0;        // farther from walls, floor and lid than a margin; 0 if nothing is
  double near_walls = 0;  // in the rest
};

/// Errors: input_error for a margin that is negative or no number.
template <class Grains>
solid_fractions solid_fractions_of(const Grains& g, const upright_cylinder& cell, double margin) {
  expects(margin >= 0 && std::isfinite(margin), "the distance of the bulk from the walls (m)", margin,
          "at least 0 and finite", "docs/reference/observe.md");
  const upright_cylinder inside{cell.radius - margin, cell.low + margin, cell.high - margin};
  const double whole = solid_fraction_within(g, cell), bulk = solid_fraction_within(g, inside);
  const double outside = cell.volume() - inside.volume();
  return {whole, bulk, outside > 0 ? (whole * cell.volume() - bulk * inside.volume()) / outside : 0};
}

}  // namespace pendular::observe
