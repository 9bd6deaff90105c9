// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/plane.hpp>
#include <pendular/core/copyable.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <string_view>

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

/// A plane lid pressed into the grains by a constant stress: a free mass along the normal, with a dashpot so that it
/// does not bounce. The stress is that of the load alone; the lid has no weight. It can slide along its plane: of
/// `sliding` the part along the plane counts.
struct servo_stress {
  static constexpr std::array<std::string_view, 1> state{"velocity"};  // what is no parameter
  double stress;                                                       // Pa
  double area;                                                         // m2
  double mass;                                                         // of the lid, kg
  double damping;                                                      // N s/m
  vector velocity{0, 0, 0};                                            // m/s
  vector sliding{0, 0, 0};                                             // m/s

  void move(plane& wall, const vector& force, double time_step) {
    const double inward = dot(velocity, wall.normal);
    const double push = dot(force, wall.normal) + stress * area;  // force is what the grains do to the wall
    const double next = (inward + time_step / mass * push) / (1.0 + time_step * damping / mass);
    velocity = next * wall.normal + (sliding - dot(sliding, wall.normal) * wall.normal);
    wall.point += time_step * velocity;
  }
};

inline void validate(const constant_velocity& c) { detail::expect_finite("the speed of a wall (m/s)", c.velocity); }

inline void validate(const servo_stress& s) {
  constexpr auto page = "docs/reference/boundary.md";
  expects(s.stress >= 0 && std::isfinite(s.stress), "the stress of a lid (Pa)", s.stress, "at least 0 and finite",
          page);
  expects(s.area > 0 && std::isfinite(s.area), "the area of a lid (m2)", s.area, "positive and finite", page);
  expects(s.mass > 0 && std::isfinite(s.mass), "the mass of a lid (kg)", s.mass, "positive and finite", page);
  expects(s.damping >= 0 && std::isfinite(s.damping), "the damping of a lid (N s/m)", s.damping,
          "at least 0 and finite", page);
  detail::expect_finite("the speed of a lid (m/s)", s.velocity);
  detail::expect_finite("the speed at which a lid slides (m/s)", s.sliding);
}

}  // namespace pendular::boundary
