// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::normal {

/// Linear elastic contact, f_e = -k_n delta_n for delta_n < 0.
/// Units: N from N/m and m. Valid for any overlap; a packing stays near its rigid limit while k_n / (P d) > 1e3.
/// Source: Richefeu et al. 2007, Eq. 2.
struct linear {
  double normal_stiffness;  // k_n, N/m

  static constexpr bool has_constant_stiffness = true;

  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    return T(normal_stiffness) * max(T(-a.gap), T(0));
  }

  template <Scalar T>
  T stiffness(const approach<T>&) const {
    return T(normal_stiffness);
  }

  /// Stored energy, J.
  template <Scalar T>
  T energy(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    return T(0.5 * normal_stiffness) * overlap * overlap;
  }
};

inline void validate(const linear& law) {
  expects(law.normal_stiffness > 0 && std::isfinite(law.normal_stiffness), "the normal stiffness k_n (N/m)",
          law.normal_stiffness, "positive and finite", "docs/reference/laws.md");
}

}  // namespace pendular::normal
