// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// Two spheres on a line under a composition of laws, by Runge-Kutta of order four with steps far finer than a simulation
// would take. It stands in for the exact solution and shares nothing with the library's integrators.
namespace two_bodies {

struct pair {
  double mass_i, mass_j;      // kg; mass_j infinite for a wall
  double radius_i, radius_j;  // m
  double reduced_mass() const { return 1 / (1 / mass_i + 1 / mass_j); }
};

struct state {
  double gap;
  double velocity_i, velocity_j;  // along the normal from i to j
  double closing_speed() const { return velocity_i - velocity_j; }
};

inline state moved(const state& s, double h, const state& rate) {
  return {s.gap + h * rate.gap, s.velocity_i + h * rate.velocity_i, s.velocity_j + h * rate.velocity_j};
}

/// `push(approach<double>) -> N` is the total repulsive force.
template <class Push>
state rate(const pair& p, const Push& push, const state& s) {
  const double force =
      push(pendular::approach<double>{s.gap, s.closing_speed(), p.reduced_mass(), p.radius_i, p.radius_j});
  return {-s.closing_speed(), -force / p.mass_i, force / p.mass_j};
}

template <class Push>
state step(const pair& p, const Push& push, const state& s, double h) {
  const state k1 = rate(p, push, s);
  const state k2 = rate(p, push, moved(s, h / 2, k1));
  const state k3 = rate(p, push, moved(s, h / 2, k2));
  const state k4 = rate(p, push, moved(s, h, k3));
  return moved(moved(moved(moved(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

struct impact {
  double duration;       // s
  double deepest;        // largest overlap, m
  double largest_force;  // N
  state before, after;
  double restitution() const { return -after.closing_speed() / before.closing_speed(); }
};

/// From first touch to the gap that opens again. The start is a hair inside, where contact forces already act.
template <class Push>
impact collide(const pair& p, const Push& push, double velocity_i, double velocity_j, double step_length) {
  state s{-1e-30, velocity_i, velocity_j};
  impact result{0, 0, 0, s, s};
  while (true) {
    const state next = step(p, push, s, step_length);
    if (next.gap >= 0) {
      const double rest = -s.gap / std::max(-s.closing_speed(), 1e-300);
      result.after = step(p, push, s, 0.999999 * std::min(rest, step_length));
      result.duration += rest;
      return result;
    }
    s = next;
    result.duration += step_length;
    result.deepest = std::max(result.deepest, -s.gap);
    result.largest_force = std::max(result.largest_force, rate(p, push, s).velocity_i * -p.mass_i);
  }
}

}  // namespace two_bodies
