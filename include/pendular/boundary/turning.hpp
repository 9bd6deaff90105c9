// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/drive.hpp>
#include <pendular/boundary/turn.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace pendular::boundary {

/// A wall that turns about an axis at a constant rate: a drum, its end plates, a ring, a vane. What stays in itself, a
/// cylinder about its own axis or a plane across it, is not moved at all; its surface still drags what touches it.
struct turning {
  static constexpr std::array<std::string_view, 1> state{"torque"};  // what is no parameter
  vector point;                                                      // any point of the axis, m
  vector axis;                                                       // unit vector
  double rate;                                                       // about it, right-handed, rad/s
  double reach = 0;        // of the surface from the axis, m; only for a shape that does not stay in itself
  vector torque{0, 0, 0};  // of the grains on the wall about the point, in the last step, N m

  template <Scalar T>
  Vec3<T> velocity_at(const Vec3<T>& p) const {
    const Vec3<T> spin{T(rate * axis.x), T(rate * axis.y), T(rate * axis.z)};
    return cross(spin, Vec3<T>{p.x - T(point.x), p.y - T(point.y), p.z - T(point.z)});
  }
  const vector& pivot() const { return point; }
  double approach_speed() const { return std::abs(rate) * reach; }

  /// Errors: a shape that turning moves, of which nobody said how far it goes: grains would not be looked for in time.
  template <class Geometry>
  void expect_shape(const Geometry& wall) const {
    expects(reach > 0 || stays_in_itself(wall, point, axis), "the reach of a wall that turning moves (m)", reach,
            "more than 0", "docs/reference/boundary.md");
  }

  template <class Geometry>
  void move(Geometry& wall, const wall_load& load, double time_step) {
    torque = load.torque;
    if (!stays_in_itself(wall, point, axis)) turn(wall, point, axis, rate * time_step);
  }
};

inline void validate(const turning& t) {
  constexpr auto page = "docs/reference/boundary.md";
  detail::expect_finite("the distance of a point of a wall's axis (m)", t.point);
  const double length = norm(t.axis);
  expects(std::abs(length - 1) < 1e-9, "the length of a wall's axis", length, "1", page);
  expects(std::isfinite(t.rate), "the rate at which a wall turns (rad/s)", t.rate, "finite", page);
  expects(t.reach >= 0 && std::isfinite(t.reach), "the reach of a turning wall (m)", t.reach, "at least 0 and finite",
          page);
}

}  // namespace pendular::boundary
