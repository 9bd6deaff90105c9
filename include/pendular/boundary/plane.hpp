// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>

#include <cmath>
#include <string_view>

namespace pendular::boundary {

/// Where a wall meets a sphere.
template <class T>
struct meeting {
  T gap;           // m
  Vec3<T> normal;  // from the grain to the wall
};

/// Infinite plane; grains are on the side its normal points to.
struct plane {
  vector point;   // any point of it, m
  vector normal;  // unit vector into the grains

  template <Scalar T>
  meeting<T> meet(const Vec3<T>& centre, const T& radius) const {
    const T height = (centre.x - T(point.x)) * T(normal.x) + (centre.y - T(point.y)) * T(normal.y) +
                     (centre.z - T(point.z)) * T(normal.z);
    return {height - radius, {T(-normal.x), T(-normal.y), T(-normal.z)}};
  }
};

namespace detail {
inline void expect_finite(std::string_view what, const vector& v) {
  expects(std::isfinite(dot(v, v)), what, norm(v), "finite", "docs/reference/boundary.md");
}
}  // namespace detail

inline void validate(const plane& p) {
  detail::expect_finite("the distance of a plane's point (m)", p.point);
  const double length = norm(p.normal);
  expects(std::abs(length - 1) < 1e-9, "the length of a plane's normal", length, "1", "docs/reference/boundary.md");
}

}  // namespace pendular::boundary
