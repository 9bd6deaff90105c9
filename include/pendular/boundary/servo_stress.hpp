// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/plane.hpp>
#include <pendular/core/expects.hpp>

#include <array>
#include <cmath>
#include <string_view>

namespace pendular::boundary {

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

  /// The mass that contacts move, kg: the dashpot acts at the end of a step, which is stable as a free mass if
  /// k dt^2 < 4 mass + 2 damping dt.
  double inertia(double time_step) const { return mass + 0.5 * time_step * damping; }
};

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
