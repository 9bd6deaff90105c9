// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/exponential_bridge.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// Explicit capillary force as printed,
///     f_c = kappa R exp(-delta_n / lambda),  R = sqrt(R_i R_j),  kappa R in overlap,
///     lambda = (c / sqrt 2) V_b^{1/2} r^{-1/2} (1/R_i + 1/R_j)^{1/2},  r = max(R_i/R_j, R_j/R_i),  c = 0.9.
/// Units: N from N/m, m, m3. Against Laplace-Young (theta = 0, r = 1) it is 4 to 27 % high at contact for V_b/R^3 in
/// [1e-4, 0.1], 15 to 46 % high at a quarter to half of the rupture distance; the geometric mean radius is 9 to 28 %
/// high at r = 2 and should not be used beyond r = 4 (docs/reference/laws.md).
/// Source: Richefeu et al. 2007, Eqs. 4-11.
struct richefeu {
  static constexpr validity valid{0, 1e300, 4, std::numbers::pi / 2};
  double decay_constant = 0.9;  // c

  template <class T>
  using coefficients = exponential_bridge<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = sqrt(T(b.radius_i * b.radius_j));
    return {T(capillary_tension(f)) * radius, decay_rate(b, decay_constant)};
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

inline void validate(const richefeu& law) {
  expects(law.decay_constant > 0 && std::isfinite(law.decay_constant), "the decay constant c", law.decay_constant,
          "positive and finite", "docs/reference/laws.md");
}

}  // namespace pendular::capillary
