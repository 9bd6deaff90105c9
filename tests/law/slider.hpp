// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>
#include <pendular/testing/friction_law.hpp>

// A block of one tangential mass on one contact, pulled along a fixed direction and stepped as a simulation steps it:
// traction from the velocity of the last step, then velocity from the traction.
namespace blocks {

template <class Law>
struct slider {
  Law law;
  double mass;          // kg
  double normal_force;  // N
  double time_step;     // s
  double velocity = 0;  // m/s
  pendular::contact_memory_t<Law, double> memory{};
  double traction = 0;  // N, along the pull

  void step(double pull) {
    const pendular::Vec3<double> along{0.36, 0.48, 0.8};
    const pendular::Vec3<double> normal{0.8, -0.6, 0.0};
    const pendular::slip<double> s{velocity * along, normal, mass, 1.0, time_step};
    traction = dot(pendular::testing::traction(law, s, normal_force, memory), along);
    velocity += time_step * (pull + traction) / mass;
  }
};
template <class Law>
slider(Law, double, double, double) -> slider<Law>;
template <class Law>
slider(Law, double, double, double, double) -> slider<Law>;

}  // namespace blocks
