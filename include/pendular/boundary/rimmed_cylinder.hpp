// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/cylinder.hpp>

namespace pendular::boundary {

/// Hollow cylinder that ends in a flat rim, one half of a direct-shear cell: all beyond the radius and beyond the rim is
/// solid. Grains are inside, or over the rim, on which they can lie. The contact law sees a plane.
struct rimmed_cylinder {
  vector point;      // where the axis crosses the plane of the rim, m
  vector direction;  // unit vector along the axis, from the rim into the half
  double radius;     // m

  template <Scalar T>
  meeting<T> meet(const Vec3<T>& centre, const T& grain_radius) const {
    const Vec3<T> axis{T(direction.x), T(direction.y), T(direction.z)};
    const Vec3<T> offset{centre.x - T(point.x), centre.y - T(point.y), centre.z - T(point.z)};
    const Vec3<T> radial = tangential_part(offset, axis);
    const T distance = norm(radial), depth = dot(offset, axis), room = T(radius) - distance;
    const T inside = unit_step(depth), beyond = max(T(-depth), T(0)), short_of = max(room, T(0));
    const T to_edge = sqrt(T(beyond * beyond + short_of * short_of));
    // Within the half the face is nearest, along the radius; outside of it the edge or, where there is no room, the rim.
    const T outward = select(inside, T(1), T(short_of / max(to_edge, T(tiny))));
    const T along = beyond / max(to_edge, T(tiny));
    const T per_length = outward / max(distance, T(tiny));
    return {select(inside, room, to_edge) - grain_radius, per_length * radial + along * axis};
  }
};

inline void validate(const rimmed_cylinder& c) { detail::validate_round(c); }

}  // namespace pendular::boundary
