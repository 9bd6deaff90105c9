// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/capillary/rational_bridge.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// f_c = 2 pi gamma R cos(theta) / (1 + 1.05 S + 2.5 S^2), S = D sqrt(R/V_b) with the full gap, R the harmonic mean.
/// Units: N from N/m, m, m3. Against Laplace-Young 4 to 27 % high at contact for V_b/R^3 in [1e-4, 0.1], 5 to 20 % low
/// beyond a quarter of the rupture distance, at theta = 0.
/// Source: C. D. Willett et al. 2000, Langmuir 16, 9396; S. Herminghaus 2005, Adv. Phys. 54, 221.
struct willett_closed_form {
  static constexpr validity valid{.largest_volume = 0.1, .largest_contact_angle = 0.3491, .planes = true};

  template <class T>
  using coefficients = rational_bridge<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = harmonic_radius(b);
    const T stretch = T(1) / (radius * sqrt(reduced_volume(b.volume, radius, 1e-30)));
    return {T(capillary_tension(f)) * radius, T(0) * radius, T(1.05) * stretch, T(2.5) * stretch * stretch};
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
