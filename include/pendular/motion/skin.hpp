// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>

namespace pendular {

/// Way of the fastest grain or wall in one step, m.
template <class System>
double longest_way(const System& s) {
  double square = 0;
  for (const vector& v : s.particles().template get<column::velocity>()) square = std::max(square, dot(v, v));
  double speed = std::max(std::sqrt(square), s.driven().fastest());
  s.for_each_wall([&](const auto& wall, const auto&) { speed = std::max(speed, wall.approach_speed()); });
  return s.integrator().time_step * speed;
}

/// Skin of the Verlet list, over the smallest radius, for which a step costs least: a skin s adds pairs that do not act in
/// proportion to s, and a list lasts for s / (2 way) steps. `way` is the longest in one step over the smallest radius.
/// It follows from where the grains are and how fast they move, never from a clock.
inline double cheapest_skin(double way) {
  // A list costs a grain 600 ns every s / (2 way) steps, the pairs within one more radius 3.5 times 6 ns in each.
  constexpr double list_over_pairs = 600.0 * 2 / (3.5 * 6);
  // Not below a tenth, so that a pair is still listed a while after its bridge broke, for those who look at it.
  return std::clamp(std::sqrt(list_over_pairs * way), 0.1, 1.0);
}

}  // namespace pendular
