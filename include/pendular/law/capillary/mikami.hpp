// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/exponential_with_offset.hpp>
#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// f_c = pi gamma R (exp(A D/R + B) + C), v = V_b/R^3, l = log10 v,
///     A = -1.1 v^{-0.53},  B = (-0.34 l - 0.96) theta^2 - 0.019 l + 0.48,  C = 0.0042 l + 0.078.
/// The logarithm is that to base 10: only then do the coefficients agree with those of Soulie et al. For equal spheres;
/// here R is the harmonic mean. Units: N from N/m, m, m3 and rad. Does not vanish as D grows: needs a rupture distance.
/// Here never less than nothing, v never below 1e-12, and exp(B) never above 2, the pull of a vanishing bridge at theta = 0.
/// Source: T. Mikami, H. Kamiya, M. Horio 1998, Chem. Eng. Sci. 53, 1927.
struct mikami {
  static constexpr validity valid{1e-4, 0.1, 1.0001, 0.35};

  template <class T>
  using coefficients = exponential_with_offset<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = harmonic_radius(b);
    const T v = reduced_volume(b.volume, radius, 1e-12);
    const T x = log(v) / T(std::numbers::ln10);
    const double square = f.contact_angle * f.contact_angle;
    const T rate = T(1.1) * pow(v, -0.53) / radius;
    const T exponent = min(T(T(-0.34 * square - 0.019) * x + T(0.48 - 0.96 * square)), T(std::numbers::ln2));
    return {T(std::numbers::pi * f.surface_tension) * radius, rate, exponent, T(T(0.0042) * x + T(0.078))};
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
