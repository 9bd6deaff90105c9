// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/exponential_bridge.hpp>
#include <pendular/law/inputs.hpp>

namespace pendular::capillary {

/// The law of `richefeu` with the harmonic (Derjaguin) mean radius R = 2 R_i R_j / (R_i + R_j) in the amplitude, which
/// Laplace-Young supports as V_b goes to 0; decay length and the rest as printed.
/// Units: N from N/m, m, m3. Valid for any size ratio at contact; the gap dependence is that of Eq. 11.
/// Source: Richefeu et al. 2007, Eqs. 4-11, with the mean radius of B. V. Derjaguin, Kolloid-Z. 69, 155 (1934).
struct richefeu_harmonic {
  double decay_constant = 0.9;  // c

  template <class T>
  using coefficients = exponential_bridge<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = T(2) / T(T(1) / b.radius_i + T(1) / b.radius_j);
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

inline void validate(const richefeu_harmonic& law) {
  expects(law.decay_constant > 0 && std::isfinite(law.decay_constant), "the decay constant c", law.decay_constant,
          "positive and finite", "docs/reference/laws.md");
}

}  // namespace pendular::capillary
