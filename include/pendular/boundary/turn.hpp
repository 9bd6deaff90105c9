// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>

#include <cmath>

namespace pendular::boundary {

/// A vector turned by an angle (rad) about a unit axis, right-handed (Rodrigues' formula).
inline vector turned(const vector& v, const vector& axis, double angle) {
  const double c = std::cos(angle);
  return c * v + std::sin(angle) * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
}

namespace detail {
/// The same for a direction, kept at length 1 through any number of steps.
inline vector turned_direction(const vector& v, const vector& axis, double angle) {
  const vector t = turned(v, axis, angle);
  return (1 / norm(t)) * t;
}

template <class Shape>
auto& direction_of(Shape& s) {
  if constexpr (requires { s.normal; }) {
    return s.normal;
  } else {
    return s.direction;
  }
}
}  // namespace detail

/// Turns a shape that has a `point` and a unit vector `normal` or `direction` about an axis through `centre`.
template <class Shape>
void turn(Shape& shape, const vector& centre, const vector& axis, double angle) {
  auto& direction = detail::direction_of(shape);
  direction = detail::turned_direction(direction, axis, angle);
  shape.point = centre + turned(shape.point - centre, axis, angle);
}

/// Whether turning about the axis leaves the shape where it is: its unit vector is along the axis and, for what is round,
/// its own axis is this one.
template <class Shape>
bool stays_in_itself(const Shape& shape, const vector& centre, const vector& axis) {
  constexpr double straight = 1e-12;
  if (norm(cross(detail::direction_of(shape), axis)) > straight) return false;
  if constexpr (requires { shape.normal; }) {
    return true;
  } else {
    return norm(cross(shape.point - centre, axis)) <= straight * shape.radius;
  }
}

}  // namespace pendular::boundary
