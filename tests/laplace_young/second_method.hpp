// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/solve.hpp>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <array>
#include <cmath>
#include <numbers>

// The Laplace-Young equation of a meridian as an initial-value problem, integrated from one contact line to the other by
// Runge-Kutta-Fehlberg 7(8): no first integral, no closed form, no quadrature in common with the solver.
namespace second_method {

using namespace pendular::laplace_young;

/// Distance from the axis, height, slope angle, volume and area up to here.
using meridian_state = std::array<double, 5>;

struct arrival {
  double radius, height, angle, volume, area;
};

inline meridian_state integrate(const meridian_state& start, double curvature, double length) {
  namespace ode = boost::numeric::odeint;
  meridian_state x = start;
  const auto slope = [&](const meridian_state& m, meridian_state& d, double) {
    const double y = m[0], c = std::cos(m[2]);
    d = {std::sin(m[2]), c, curvature + c / y, std::numbers::pi * y * y * c, 2 * std::numbers::pi * y};
  };
  ode::integrate_adaptive(ode::make_controlled(1e-14, 1e-14, ode::runge_kutta_fehlberg78<meridian_state>()), slope, x,
                          0.0, length, length / 16);
  return x;
}

/// The meridian of a state from contact line i up to contact line j, all lengths over `unit`. Where it runs along the plane
/// of the contact line its radius tells where the end is, else its height.
inline arrival arrive(const state& s, const liquid_bridge& b, double unit) {
  const double start_angle = s.filling_angle_i + b.contact_angle - std::numbers::pi / 2;
  const auto sagitta = [](double radius, double angle) {
    return std::isinf(radius) ? 0.0 : 2 * radius * std::pow(std::sin(angle / 2), 2);
  };
  const double height =
      (s.gap + sagitta(b.radius_i, s.filling_angle_i) + sagitta(b.radius_j, s.filling_angle_j)) / unit;
  const double curvature = s.suction / b.surface_tension * unit;
  const meridian_state first{s.contact_radius_i / unit, 0, start_angle, 0, 0};
  const double end_angle = std::numbers::pi / 2 - b.contact_angle - s.filling_angle_j;
  const bool flat = std::cos(end_angle) < 0.5;
  double length = height;
  meridian_state end{};
  for (int k = 0; k < 40; ++k) {  // Newton for the length
    end = integrate(first, curvature, length);
    const bool by_radius = flat && k > 15;
    const double step =
        by_radius ? (s.contact_radius_j / unit - end[0]) / std::sin(end[2]) : (height - end[1]) / std::cos(end[2]);
    length += step;
    if (std::abs(step) < 1e-15 * length && (by_radius || !flat)) break;
  }
  return {end[0] * unit, (end[1] - height) * unit, end[2], end[3] * unit * unit * unit, end[4] * unit * unit};
}

}  // namespace second_method
