// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace pendular::laplace_young {

namespace detail {

/// The real number under a scalar that carries derivatives, or the scalar itself.
template <class T>
struct real_of {
  using type = T;
};
template <class T>
  requires requires(const T& x) { x.derivatives(); }
struct real_of<T> {
  using type = double;
};
template <class T>
using real_t = typename real_of<T>::type;

template <class T>
double value_of(const T& x) {
  if constexpr (std::is_same_v<real_t<T>, T>) {
    return static_cast<double>(x);
  } else {
    return x.value();
  }
}

/// sin(x) / x; in double its derivative near 0 needs the series.
template <class T>
T sine_over(const T& x) {
  using std::abs, std::sin;
  if (abs(x) > real_t<T>(0.05)) return T(sin(x) / x);
  const T q = x * x;
  return T(1) - q / 6 * (T(1) - q / 20 * (T(1) - q / 42 * (T(1) - q / 72 * (T(1) - q / 110))));
}

}  // namespace detail

/// Meridian of a surface of constant mean curvature about an axis, by arc length from its first end.
///
/// With y the distance from the axis, psi the angle against it and k = (p_gas - p_liquid)/gamma, Laplace-Young reads
/// dpsi/ds = k + cos(psi)/y and has the first integral y cos(psi) + k y^2/2 = f, which is the force over 2 pi gamma.
/// Then (y^2)'' + k^2 y^2 = 2 (1 + k f): y^2 is a sine of the arc length for every k, 0 included, and what is left are
/// quadratures of smooth functions. Lengths in any one unit.
template <class T>
struct meridian {
  T radius;  // y at the first end
  T rising;  // dy/ds there, sin(psi)
  T force;   // f
  T turn;    // k times length, rad
  T length;

  T curvature() const { return T(turn / length); }

  /// y^2 at the part t of the length, t in [0, 1].
  T square_radius(const detail::real_t<T>& t) const {
    using std::cos;
    const T half = turn * (t / 2);
    const T chord = t * detail::sine_over(half);  // 2 sin(half) / turn
    return radius * radius * (1 - turn * turn * chord * chord / 2) +
           chord * (2 * radius * rising * length * cos(half) + length * (length + turn * force) * chord);
  }

  /// y dy/ds at the second end.
  T rise_times_radius_at_end() const {
    using std::cos;
    return radius * rising * cos(turn) +
           detail::sine_over(turn) * (length + turn * force - turn * turn * radius * radius / (2 * length));
  }

  struct integrals {
    T height, volume, area;  // of the body of revolution; the area without its ends
  };

  /// Smallest distance from the axis, at an end or where y^2 has its minimum between them.
  double neck() const {
    const double y = detail::value_of(radius), l = detail::value_of(length), kl = detail::value_of(turn);
    double square = std::min(y * y, detail::value_of(square_radius(1)));
    const double rise = 2 * y * detail::value_of(rising) * l;
    const double bend = 2 * l * (l + kl * detail::value_of(force)) - kl * kl * y * y;
    // d(y^2)/dt = rise cos(turn t) + bend sin(turn t) / turn
    const double pi = boost::math::constants::pi<double>(), pace = std::max(std::abs(kl), 1e-6);
    const double phase = std::atan2(-rise * pace, bend);
    for (double t = (phase < 0 ? phase + pi : phase) / pace; t < 1; t += pi / pace) {
      square = std::min(square, detail::value_of(square_radius(t)));
    }
    return std::sqrt(square);
  }

  /// Up to the part `until` of the length. A slender neck brings the roots of y^2 near, and asks for more
  /// points; so does a number of more digits.
  integrals integrate(const detail::real_t<T>& until = 1) const {
    if constexpr (!std::is_same_v<detail::real_t<T>, double>) return integrate_by<160>(until);
    return neck() < 0.17 * detail::value_of(length) ? integrate_by<96>(until) : integrate_by<48>(until);
  }

  /// Gauss-Legendre with Points points.
  template <unsigned Points>
  integrals integrate_by(const detail::real_t<T>& until = 1) const {
    using real = detail::real_t<T>;
    using rule = boost::math::quadrature::gauss<real, Points>;
    const T k = curvature();
    integrals sum{T(0), T(0), T(0)};
    const auto add = [&](const real& t, const real& weight) {
      using std::sqrt;
      const T u = square_radius(t);
      const T y = sqrt(u);
      const T along = force - k * u / 2;  // y cos(psi)
      sum.height += weight * (along / y);
      sum.volume += weight * (along * y);
      sum.area += weight * y;
    };
    for (std::size_t n = 0; n < rule::abscissa().size(); ++n) {
      const real x = rule::abscissa()[n], weight = until * rule::weights()[n] / 2;
      add(until * (1 + x) / 2, weight);
      if (x != 0) add(until * (1 - x) / 2, weight);
    }
    const real pi = boost::math::constants::pi<real>();
    return {T(length * sum.height), T(pi * length * sum.volume), T(2 * pi * length * sum.area)};
  }
};

}  // namespace pendular::laplace_young
