// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/motion/mover.hpp>
#include <pendular/motion/velocity_verlet.hpp>
#include <pendular/testing/report.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace pendular::testing {

/// x'' = -omega2 x - rate x' + push
struct oscillator {
  double omega2;    // 1/s2
  double rate;      // 1/s
  double push = 0;  // m/s2

  double acceleration(double x, double v) const { return push - omega2 * x - rate * v; }
};

namespace detail {

/// Where a body on a line is, how fast it is, and its acceleration by the last forces.
struct motion_state {
  double x, v, a;
};

template <class I>
motion_state stepped(const I& integrator, const oscillator& o, const motion_state& s) {
  vector position{s.x, 0, 0}, velocity{s.v, 0, 0};
  integrator.predict(position, velocity, vector{s.a, 0, 0});
  const double now = o.acceleration(position.x, velocity.x);
  integrator.correct(velocity, vector{s.a, 0, 0}, vector{now, 0, 0});
  return {position.x, velocity.x, now};
}

template <class Make>
motion_state after_one_second(const Make& make, const oscillator& o, int steps) {
  const auto integrator = make(1.0 / steps, vector{0, 0, 0});
  motion_state s{1, 0.5, o.acceleration(1, 0.5)};
  for (int k = 0; k < steps; ++k) s = stepped(integrator, o, s);
  return s;
}

/// Distance from the exact solution in position and velocity, for a rate below critical.
template <class Make>
double error_after_one_second(const Make& make, const oscillator& o, int steps) {
  const motion_state s = after_one_second(make, o, steps);
  const double decay = 0.5 * o.rate, omega = std::sqrt(o.omega2 - decay * decay);
  const double c = std::cos(omega), d = (0.5 + decay) / omega, e = std::exp(-decay);
  const double x = e * (c + d * std::sin(omega));
  const double v = -decay * x + e * omega * (d * c - std::sin(omega));
  return std::hypot(s.x - x, (s.v - v) / omega);
}

template <class Make>
void demand_order(report& broken, const Make& make, const oscillator& o, double least, std::string_view property) {
  const double coarse = error_after_one_second(make, o, 1000), fine = error_after_one_second(make, o, 2000);
  const double order = std::log2(coarse / fine);
  demand(broken, fine < 1e-10 || order > least - 0.1, property, {{"promised", least}, {"found", order}});
}

/// What is given is carried, and bodies without forces, or under gravity alone, go as they must.
template <class Make>
void demand_free_fall(report& broken, const Make& make, double order) {
  const double step = 1e-3, g = 9.81;
  const int steps = 1000;
  const auto integrator = make(step, vector{0, 0, -g});
  demand(broken, integrator.time_step == step && vector(integrator.gravity) == vector{0, 0, -g},
         "the integrator must have the time step and the gravity that it was made with",
         {{"time step", integrator.time_step}, {"gravity", vector(integrator.gravity).z}});
  for (const double pull : {0.0, -g}) {
    const oscillator free{0, 0, pull};
    motion_state s{0, 3, pull};
    for (int k = 0; k < steps; ++k) s = stepped(integrator, free, s);
    const double t = steps * step, x = 3 * t + 0.5 * pull * t * t;
    const double granted = 1e-10 + (order < 2 ? std::abs(pull) * t * step : 0);
    demand(broken, agree(s.v, 3 + pull * t, 1e-11), "the speed of free fall must be exact",
           {{"acceleration", pull}, {"speed", s.v}, {"exact", 3 + pull * t}});
    demand(broken, std::abs(s.x - x) <= granted, "the way of free fall must be exact, or off by a step at first order",
           {{"acceleration", pull}, {"way", s.x}, {"exact", x}});
  }
}

/// The velocities that forces see are as old as the integrator says, and spins are integrated as velocities are.
template <class Make>
void demand_lag(report& broken, const Make& make) {
  using integration = std::remove_cvref_t<decltype(make(1.0, vector{}))>;
  const double step = 1e-2;
  const auto integrator = make(step, vector{0, 0, 0});
  const vector push{3, -2, 5};
  vector position{1, 2, 3}, velocity{4, 5, 6}, spin{4, 5, 6};
  integrator.predict(position, velocity, push);
  integrator.predict_spin(spin, push);
  const double lag = (4 + step * push.x - velocity.x) / (step * push.x);
  demand(broken, agree(lag, integration::velocity_lag, 1e-9, 1e-9),
         "the velocities that forces see must be as old as velocity_lag says",
         {{"velocity_lag", integration::velocity_lag}, {"steps", lag}});
  demand(broken, norm(spin - velocity) <= 1e-14 * norm(velocity), "spins must be predicted as velocities are",
         {{"spin", norm(spin)}, {"velocity", norm(velocity)}});
}

/// Within the stable step nothing grows without bound.
template <class Make>
void demand_stable_step(report& broken, const Make& make, double omega2, double rate) {
  using integration = std::remove_cvref_t<decltype(make(1.0, vector{}))>;
  const double step = integration::stable_step(omega2, rate);
  const std::initializer_list<quantity> of = {{"omega2", omega2}, {"rate", rate}, {"stable step", step}};
  demand(broken, step > 0 && std::isfinite(step), "the stable step must be positive and finite", of);
  demand(broken,
         agree(integration::stable_step(4 * omega2, 2 * rate), 0.5 * step, 1e-9) &&
             integration::stable_step(2 * omega2, rate) <= step * (1 + 1e-12) &&
             integration::stable_step(omega2, 2 * rate + 1) <= step * (1 + 1e-12),
         "the stable step must be a time that does not grow with stiffness or damping", of);
  if (!(step > 0 && std::isfinite(step))) return;
  const auto integrator = make(0.99 * step, vector{0, 0, 0});
  const oscillator o{omega2, rate};
  const double speed = std::sqrt(omega2);
  motion_state s{1, speed, o.acceleration(1, speed)};
  double largest = 1;
  for (int k = 0; k < 20000 && largest < 1e3; ++k) {
    s = stepped(integrator, o, s);
    largest = std::max(largest, std::isfinite(s.x) ? std::abs(s.x) : HUGE_VAL);
  }
  demand(broken, largest < 1e3, "an oscillator must stay bounded at 0.99 of the stable step", of);
}

/// One whose functions take rows moves them as it moves vectors.
template <class I>
void demand_same_in_rows(report& broken, const I& integrator) {
  if constexpr (pendular::detail::TakesRows<I>) {
    vector x{1, 2, 3}, v{4, 5, 6};
    const vector a{7, -8, 9}, b{-1, 2, 4};
    pendular::detail::four rows_x = pendular::detail::load_row(quad{1, 2, 3, 0}),
                           rows_v = pendular::detail::load_row(quad{4, 5, 6, 0});
    const pendular::detail::four rows_a = pendular::detail::load_row(quad{7, -8, 9, 0}),
                                 rows_b = pendular::detail::load_row(quad{-1, 2, 4, 0});
    integrator.predict(x, v, a), integrator.correct(v, a, b);
    integrator.predict(rows_x, rows_v, rows_a), integrator.correct(rows_v, rows_a, rows_b);
    const vector found{rows_x[0], rows_x[1], rows_x[2]}, fast{rows_v[0], rows_v[1], rows_v[2]};
    demand(broken, norm(found - x) <= 1e-14 * norm(x) && norm(fast - v) <= 1e-14 * norm(v),
           "rows must move as vectors do", {{"position", norm(x)}, {"in rows", norm(found)}});
  }
}
}  // namespace detail

/// What an integrator promises beyond its signature. `make(time step, gravity)` makes one, `order` is the order to which it
/// follows an oscillator without dashpots; one whose velocities lag is of first order beside dashpots.
template <class Make>
report integrator_report(const Make& make, double order = 2) {
  using integration = std::remove_cvref_t<decltype(make(1.0, vector{}))>;
  static_assert(Integrator<integration>, "make(time step, gravity) makes an integrator");
  report broken;
  detail::demand_free_fall(broken, make, order);
  detail::demand_lag(broken, make);
  detail::demand_order(broken, make, {50, 0}, order, "the error of an oscillator must fall with the promised order");
  const double damped = integration::velocity_lag == 0 ? order : std::min(order, 1.0);
  detail::demand_order(broken, make, {50, 3}, damped, "the error of a damped oscillator must fall with its order");
  for (const double omega2 : {1.0, 1e4, 1e12}) {
    for (const double share : {0.0, 0.1, 1.0, 4.0}) {
      detail::demand_stable_step(broken, make, omega2, share * std::sqrt(omega2));
    }
  }
  detail::demand_same_in_rows(broken, make(1e-2, vector{0, 0, 0}));
  return broken;
}

}  // namespace pendular::testing
