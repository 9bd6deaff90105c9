// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/capillary/rational_bridge.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// Fit to Laplace-Young for equal spheres, v = V_b/R^3:
///     p = v^0.26 + (0.285 - 0.4594 theta) v^(0.6327 + 0.897 theta),
///     S = (D/D_r) (1 + theta cos(theta) cos(p + theta) / 2),  D_r/R = (1 + theta/2) (v^(1/3) + v^(2/3)/10),
///     f_c = gamma R (2 pi - 2.082 p^0.9197) (cos theta - 0.16 p (1 + p) tan theta)
///           / (1 + 0.8438 p^-0.724 S + 1.3393 p^-1.459 S^2).
/// R is the harmonic mean; the force is never less than nothing, v never below 1e-12 nor above 1, where p would turn.
/// Units: N from N/m, m, m3 and rad. Against Laplace-Young within 0.5 % at contact for every angle to 40 degrees; over the gap 6 % at theta = 0, 12 % at 20, 24 % at 40 up to three quarters of the rupture distance.
/// Source: G. Lian, J. Seville 2016, Adv. Colloid Interface Sci. 227, 53.
struct lian_seville {
  static constexpr validity valid{
      .least_volume = 1e-5, .largest_volume = 0.1, .largest_contact_angle = 0.35, .planes = true};

  template <class T>
  using coefficients = rational_bridge<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const double t = f.contact_angle;
    const T radius = harmonic_radius(b), v = reduced_volume(b.volume, radius, 1e-12, 1);
    const T p = pow(v, 0.26) + T(0.285 - 0.4594 * t) * pow(v, 0.6327 + 0.897 * t);
    const T third = cbrt(v);
    const T rupture = T(1 + 0.5 * t) * radius * (third + T(0.1) * third * third);
    const T stretch = (T(1) + T(0.5 * t * std::cos(t)) * cos(T(p + T(t)))) / rupture;
    const T wetting = T(std::cos(t)) - T(0.16 * std::tan(t)) * p * (T(1) + p);
    const T force = T(f.surface_tension) * radius * (T(2 * std::numbers::pi) - T(2.082) * pow(p, 0.9197)) * wetting;
    return {max(force, T(0)), T(0) * radius, T(0.8438) * pow(p, -0.724) * stretch,
            T(1.3393) * pow(p, -1.459) * stretch * stretch};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    return c.attraction(gap);
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return prepare(b, f).attraction(b.gap);
  }
};

}  // namespace pendular::capillary
