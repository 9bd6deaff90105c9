// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/plane.hpp>

namespace pendular::boundary {

/// Infinite hollow cylinder with the grains inside. The contact law sees a plane: its radius is large against theirs.
struct cylinder {
  vector point;      // any point of the axis, m
  vector direction;  // unit vector along the axis
  double radius;     // m

  template <Scalar T>
  meeting<T> meet(const Vec3<T>& centre, const T& grain_radius) const {
    const Vec3<T> axis{T(direction.x), T(direction.y), T(direction.z)};
    const Vec3<T> offset{centre.x - T(point.x), centre.y - T(point.y), centre.z - T(point.z)};
    const Vec3<T> radial = tangential_part(offset, axis);
    const T distance = norm(radial);
    const T inverse = T(1) / max(distance, T(tiny));
    return {T(radius) - distance - grain_radius, inverse * radial};
  }
};

namespace detail {
template <class Round>
void validate_round(const Round& c) {
  constexpr auto page = "docs/reference/boundary.md";
  expect_finite("the distance of a point of a cylinder's axis (m)", c.point);
  const double length = norm(c.direction);
  expects(std::abs(length - 1) < 1e-9, "the length of a cylinder's direction", length, "1", page);
  expects(c.radius > 0 && std::isfinite(c.radius), "the radius of a cylinder (m)", c.radius, "positive and finite",
          page);
}
}  // namespace detail

inline void validate(const cylinder& c) { detail::validate_round(c); }

}  // namespace pendular::boundary
