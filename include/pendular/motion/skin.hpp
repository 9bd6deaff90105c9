// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>

namespace pendular {

/// Way of the fastest in one step, m: one of the grains, or of what else moves in the scene with the speed `others`, m/s.
template <class Grains>
double longest_way(const Grains& g, double others, double time_step) {
  double square = 0;
  for (const vector& v : g.template get<column::velocity>()) square = std::max(square, dot(v, v));
  return time_step * std::max(std::sqrt(square), others);
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
