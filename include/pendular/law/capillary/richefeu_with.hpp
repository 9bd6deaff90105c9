// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/exponential_bridge.hpp>
#include <pendular/law/concepts.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// Explicit capillary force of Richefeu et al. with a mean radius R of one's choice,
///     f_c = kappa R exp(-delta_n / lambda),  kappa R in overlap,
///     lambda = (c / sqrt 2) V_b^{1/2} r^{-1/2} (1/R_i + 1/R_j)^{1/2},  r = max(R_i/R_j, R_j/R_i),  c = 0.9.
/// Only the amplitude takes the mean: the decay length is that of Eq. 11 with any of them. The names with a mean are
/// `richefeu`, as printed, and `richefeu_harmonic`.
/// Units: N from N/m, m, m3. Valid where the mean is.
/// Source: Richefeu et al. 2007, Eqs. 4-11.
template <class Mean>
struct richefeu_with {
  static_assert(MeanRadius<Mean>,
                "capillary::richefeu_with takes a mean radius, such as mean_radius::harmonic (docs/reference/laws.md)");

  static constexpr validity valid = validity_of<Mean>();
  double decay_constant = 0.9;  // c
  [[no_unique_address]] Mean mean{};

  template <class T>
  using coefficients = exponential_bridge<T>;

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = mean.of(b);
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

template <class Mean>
richefeu_with(double, Mean) -> richefeu_with<Mean>;

template <class Mean>
void validate(const richefeu_with<Mean>& law) {
  expects(law.decay_constant > 0 && std::isfinite(law.decay_constant), "the decay constant c", law.decay_constant,
          "positive and finite", "docs/reference/laws.md");
  if constexpr (requires { validate(law.mean); }) validate(law.mean);
}

}  // namespace pendular::capillary
