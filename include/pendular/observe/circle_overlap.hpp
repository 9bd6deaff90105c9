// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pendular::observe {

namespace detail {
/// Segment of a circle beyond a chord at this distance from its centre, negative beyond the centre, m2.
inline double segment_area(double radius, double distance) {
  const double ratio = std::clamp(distance / radius, -1.0, 1.0);
  return radius * radius * (std::acos(ratio) - ratio * std::sqrt(1 - ratio * ratio));
}
}  // namespace detail

/// Area that two circles share, m2, from their radii and the distance of their centres, m; to 1e-12 of the smaller one for
/// circles of similar size, 1e-7 where one is a thousand times the other.
inline double circle_overlap(double radius_a, double radius_b, double distance) {
  const double smaller = std::min(radius_a, radius_b);
  if (distance >= radius_a + radius_b) return 0;
  if (distance <= std::abs(radius_a - radius_b)) return std::numbers::pi * smaller * smaller;
  const double chord_a = (distance * distance + radius_a * radius_a - radius_b * radius_b) / (2 * distance);
  return detail::segment_area(radius_a, chord_a) + detail::segment_area(radius_b, distance - chord_a);
}

}  // namespace pendular::observe
