// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>

#include <cmath>
#include <string_view>

namespace pendular {

// Always inlined: with some flags g++ 12 leaves `predict` out of the flattened loop, which costs 5 % of the instructions
// of a dry step.

/// Velocity Verlet whose dissipative forces see the velocity extrapolated to the same time as the positions,
/// v + a dt. Second order in dashpots too, and free of the unphysical sticking that half-step velocities cause between
/// grains of very different size (Vyas et al. 2025); the stable step under strong damping is about half as long, and
/// friction springs get a dashpot k_t dt / 2 beside them (docs/explanation/integrators.md).
/// Source: Allen and Tildesley, Computer Simulation of Liquids (1987), section 3.2.
struct velocity_verlet {
  static constexpr double velocity_lag =
      0;  // steps by which the velocities the forces see are older than the positions

  double time_step;         // s
  vector gravity{0, 0, 0};  // m/s2

  template <class V>
  [[gnu::always_inline]] void predict(V& position, V& velocity, const V& acceleration) const {
    const double dt = time_step;
    position += dt * velocity + (0.5 * dt * dt) * acceleration;
    velocity += dt * acceleration;
  }
  template <class V>
  [[gnu::always_inline]] void predict_spin(V& spin, const V& acceleration) const {
    spin += time_step * acceleration;
  }

  template <class V>
  [[gnu::always_inline]] void correct(V& velocity, const V& before, const V& now) const {
    velocity += (0.5 * time_step) * (now - before);
  }

  /// Largest stable step, s, of x'' = -omega2 x - rate x' with omega2 in 1/s2 and rate in 1/s.
  static double stable_step(double omega2, double rate) { return 2.0 / (std::sqrt(rate * rate + omega2) + rate); }
};

/// Velocity Verlet whose dissipative forces see the velocity of half a step ago, as most DEM codes have it: first order
/// in dashpots (restitution is off by up to 1 % at 200 steps per contact), stable up to about twice the step of
/// `velocity_verlet` under strong damping.
/// Source: Allen and Tildesley, Computer Simulation of Liquids (1987), section 3.2.
struct half_step_velocity_verlet {
  static constexpr double velocity_lag = 0.5;  // steps

  double time_step;         // s
  vector gravity{0, 0, 0};  // m/s2

  template <class V>
  [[gnu::always_inline]] void predict(V& position, V& velocity, const V& acceleration) const {
    velocity += (0.5 * time_step) * acceleration;
    position += time_step * velocity;
  }
  template <class V>
  [[gnu::always_inline]] void predict_spin(V& spin, const V& acceleration) const {
    spin += (0.5 * time_step) * acceleration;
  }

  template <class V>
  [[gnu::always_inline]] void correct(V& velocity, const V& /*before*/, const V& now) const {
    velocity += (0.5 * time_step) * now;
  }

  /// Largest stable step, s, of x'' = -omega2 x - rate x' with omega2 in 1/s2 and rate in 1/s.
  static double stable_step(double omega2, double rate) {
    const double half = 0.5 * rate;
    return 2.0 / (std::sqrt(half * half + omega2) + half);
  }
};

namespace detail {
inline void validate_step(double time_step, const vector& gravity) {
  constexpr auto page = "docs/reference/integrators.md";
  expects(time_step > 0 && std::isfinite(time_step), "the time step (s)", time_step, "positive and finite", page);
  const double g = dot(gravity, gravity);
  expects(std::isfinite(g), "the square of gravity (m2/s4)", g, "finite", page);
}
}  // namespace detail

inline void validate(const velocity_verlet& v) { detail::validate_step(v.time_step, v.gravity); }
inline void validate(const half_step_velocity_verlet& v) { detail::validate_step(v.time_step, v.gravity); }

/// Moves grains from one step to the next in two halves around the evaluation of the forces. Its functions may be
/// templates in the type of the vectors: they are then called with rows of four numbers, which have + and multiplication by
/// a double as a vector has, and are faster.
template <class I>
concept Integrator = Copyable<I> && requires(const I integrator, vector& changed, const vector a) {
  { integrator.time_step } -> std::convertible_to<double>;
  { integrator.gravity } -> std::convertible_to<vector>;
  integrator.predict(changed, changed, a);
  integrator.predict_spin(changed, a);
  integrator.correct(changed, a, a);
  { I::stable_step(1.0, 1.0) } -> std::convertible_to<double>;
  { I::velocity_lag } -> std::convertible_to<double>;
};

}  // namespace pendular
