// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/plane.hpp>
#include <pendular/core/copyable.hpp>

#include <concepts>

namespace pendular::boundary {

/// What grains do to a wall in a step.
struct wall_load {
  vector force{0, 0, 0};   // N
  vector torque{0, 0, 0};  // about the pivot of its drive, N m; only where the drive turns
  double power = 0;        // of the wall on the grains, W; only where the drive turns
};

/// A drive that moves all points of a wall alike.
template <class D>
concept HasOneVelocity = requires(const D drive) {
  { drive.velocity } -> std::convertible_to<vector>;
};

/// A drive that moves every point of a wall with a velocity of its own, and turns it about a pivot.
template <class D>
concept HasVelocityField = requires(const D drive, const Vec3<double>& point) {
  { drive.velocity_at(point) } -> std::convertible_to<Vec3<double>>;
  { drive.pivot() } -> std::convertible_to<vector>;
  { drive.approach_speed() } -> std::convertible_to<double>;
};

/// What moves a wall of a shape: the velocity of its points, and `move(shape, force or load, time step)` once per step.
template <class D, class Shape>
concept Drive = Copyable<D> &&(HasOneVelocity<D> || HasVelocityField<D>)&&(
    requires(D drive, Shape& shape, const wall_load& load) { drive.move(shape, load, 1e-6); } ||
    requires(D drive, Shape& shape, const vector& force) { drive.move(shape, force, 1e-6); });

/// Largest speed at which a wall may come nearer to a grain, m/s.
template <class D>
double approach_speed(const D& drive) {
  if constexpr (HasOneVelocity<D>) {
    return norm(vector(drive.velocity));
  } else {
    return drive.approach_speed();
  }
}

/// A wall that stays where it is.
struct fixed {
  static constexpr vector velocity{0, 0, 0};
  template <class Geometry>
  void move(Geometry&, const vector& /*force*/, double /*time_step*/) {}
};

/// A wall at constant velocity.
struct constant_velocity {
  vector velocity;  // m/s

  template <class Geometry>
  void move(Geometry& wall, const vector& /*force*/, double time_step) {
    wall.point += time_step * velocity;
  }
};

inline void validate(const constant_velocity& c) { detail::expect_finite("the speed of a wall (m/s)", c.velocity); }

}  // namespace pendular::boundary
