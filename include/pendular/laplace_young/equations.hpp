// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/meridian.hpp>

#include <Eigen/Core>
#include <Eigen/LU>
#include <unsupported/Eigen/AutoDiff>

#include <array>
#include <cmath>

namespace pendular::laplace_young {

namespace detail {

/// A body of revolution that the liquid wets: sphere of the given curvature, or plane (0).
template <class T>
struct cap {
  T radius;  // of the contact line
  T height;  // from the top of the body to the contact line
  T volume;  // of the body in between
  T area;    // wetted
  T slope;   // filling angle, rad
};

/// `arc` is the length along the body from its top to the contact line.
template <class T, class Real>
cap<T> cap_of(const T& arc, const Real& curvature) {
  const Real pi = boost::math::constants::pi<Real>();
  const T half = sine_over(T(arc * (curvature / 2)));
  const T q = arc * arc * half * half / 2;  // (1 - cos(curvature arc)) / curvature^2
  return {T(arc * sine_over(T(arc * curvature))), T(curvature * q),
          T(pi * curvature * q * q * (3 - curvature * curvature * q) / 3), T(2 * pi * q), T(curvature * arc)};
}

/// Places of the six numbers that describe a bridge. Lengths in units of a reference length, logarithms because all
/// scales differ.
enum place { log_arc_i, log_arc_j, turn, log_length, log_volume, gap, places };

/// What the two bodies and the liquid fix.
template <class Real>
struct geometry {
  Real curvature_i, curvature_j;  // of the bodies
  Real contact_angle;             // rad
};

template <class T, class Real>
meridian<T> meridian_of(const geometry<Real>& g, const std::array<T, places>& z) {
  using std::cos, std::exp, std::sin;
  const cap<T> first = cap_of(T(exp(z[log_arc_i])), g.curvature_i);
  const T angle = first.slope + g.contact_angle;
  const T length = exp(z[log_length]);
  const T force = first.radius * (sin(angle) + z[turn] * first.radius / (2 * length));
  return {first.radius, T(-cos(angle)), force, z[turn], length};
}

/// The four equations of a bridge: the meridian reaches the second body at its contact line and under the contact angle,
/// its height fits the gap, and it holds the volume. All are 0 at a solution and of order one elsewhere.
template <class T, class Real>
std::array<T, 4> residuals(const geometry<Real>& g, const std::array<T, places>& z) {
  using std::cos, std::exp, std::sin;
  const meridian<T> m = meridian_of(g, z);
  const cap<T> first = cap_of(T(exp(z[log_arc_i])), g.curvature_i);
  const cap<T> second = cap_of(T(exp(z[log_arc_j])), g.curvature_j);
  const auto sum = m.integrate();
  const T square = m.square_radius(Real(1));
  const T end = square / (second.radius * second.radius) - 1;
  // The sine of the difference of the angles: a difference of sines would not tell a slope from its mirror image.
  const T along = m.force - m.curvature() * square / 2;
  const T required = second.slope + g.contact_angle;
  const T angle = (m.rise_times_radius_at_end() * sin(required) - along * cos(required)) / second.radius;
  const T height = (sum.height - first.height - second.height - z[gap]) / m.length;
  const T volume = (sum.volume - first.volume - second.volume) * exp(T(-z[log_volume])) - 1;
  return {end, angle, height, volume};
}

using vector6 = Eigen::Matrix<double, places, 1>;
using matrix6 = Eigen::Matrix<double, places, places>;

struct linearised {
  Eigen::Matrix<double, 4, 1> residual;
  Eigen::Matrix<double, 4, places> slope;
};

inline linearised linearise(const geometry<double>& g, const vector6& z) {
  using number = Eigen::AutoDiffScalar<vector6>;
  std::array<number, places> x;
  for (int k = 0; k < places; ++k) x[static_cast<std::size_t>(k)] = number(z[k], places, k);
  const auto r = residuals(g, x);
  linearised l;
  for (int k = 0; k < 4; ++k) {
    l.residual[k] = r[static_cast<std::size_t>(k)].value();
    l.slope.row(k) = r[static_cast<std::size_t>(k)].derivatives();
  }
  return l;
}

}  // namespace detail

}  // namespace pendular::laplace_young
