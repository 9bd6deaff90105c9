// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/trouble.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/space/cell_grid.hpp>
#include <pendular/space/grains.hpp>

#include <cmath>
#include <cstdint>
#include <string>

namespace pendular {

namespace detail {
inline bool inside(const box& b, const vector& p) {
  return b.lower.x <= p.x && p.x <= b.upper.x && b.lower.y <= p.y && p.y <= b.upper.y && b.lower.z <= p.z &&
         p.z <= b.upper.z;
}
}  // namespace detail

/// Errors: a position or velocity that is not finite, a radius that is no length, a grain outside of the domain.
template <class Grains>
void check_grains(const Grains& g, const box& domain, std::int64_t step) {
  const auto position = g.template get<column::position>();
  const auto velocity = g.template get<column::velocity>();
  const auto radius = g.template get<column::radius>();
  const auto id = g.template get<column::id>();
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double motion = dot(position[k], position[k]) + dot(velocity[k], velocity[k]);
    if (!std::isfinite(motion)) {
      throw run_error(detail::at_step(id[k], step) +
                      " has a position or velocity that is not finite: the step is too long for a stiff law, or a law "
                      "returned a value that is not finite (see docs/how-to/stability.md)");
    }
    if (!(radius[k] > 0 && std::isfinite(radius[k]))) {
      throw run_error(detail::at_step(id[k], step) + " has a radius of " + detail::number(radius[k]) +
                      " m, which must be positive and finite (see docs/reference/grains.md)");
    }
    if (!detail::inside(domain, position[k])) {
      throw run_error(detail::at_step(id[k], step) + " is lost at (" + detail::number(position[k].x) + ", " +
                      detail::number(position[k].y) + ", " + detail::number(position[k].z) +
                      ") m, outside of the domain: no wall holds it (see docs/how-to/stability.md)");
    }
  }
}

}  // namespace pendular
