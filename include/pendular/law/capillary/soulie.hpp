// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/exponential_with_offset.hpp>
#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// f_c = pi gamma sqrt(R_i R_j) (c + exp(a D/R + b)), R the larger radius, v = V_b/R^3,
///     a = -1.1 v^{-0.53},  b = (-0.148 ln v - 0.96) theta^2 - 0.0082 ln v + 0.48,  c = 0.0018 ln v + 0.078.
/// Units: N from N/m, m, m3 and rad. Does not vanish as D grows: needs a rupture distance. Here never
/// less than nothing, v never below 1e-12, and exp(b) never above 2, the pull of a vanishing bridge at theta = 0.
/// Source: F. Soulie, F. Cherblanc, M. S. El Youssoufi, C. Saix 2006, Int. J. Numer. Anal. Methods Geomech. 30, 213,
/// p. 218.
struct soulie {
  static constexpr validity valid{1e-4, 0.1, 4, 0.35};

  template <class T>
  using coefficients = exponential_with_offset<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T large = max(b.radius_i, b.radius_j);
    const T v = reduced_volume(b.volume, large, 1e-12);
    const T x = log(v);
    const double square = f.contact_angle * f.contact_angle;
    const T rate = T(1.1) * pow(v, -0.53) / large;
    const T exponent = min(T(T(-0.148 * square - 0.0082) * x + T(0.48 - 0.96 * square)), T(std::numbers::ln2));
    return {T(std::numbers::pi * f.surface_tension) * geometric_radius(b), rate, exponent, T(T(0.0018) * x + T(0.078))};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    return c.attraction(gap);
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return prepare(b, f).attraction(b.gap);
  }

  /// Work from the gap of b to the rupture distance, J.
  template <Scalar T>
  T energy(const bridge<T>& b, const fluid& f, const T& rupture_distance) const {
    return prepare(b, f).work(b.gap, rupture_distance);
  }
};

}  // namespace pendular::capillary
