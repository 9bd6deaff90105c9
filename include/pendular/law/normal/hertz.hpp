// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::normal {

/// Hertz contact of two spheres of one material, f_e = (4/3) E* sqrt(R*) overlap^{3/2},
/// E* = E / (2 (1 - nu^2)), 1/R* = 1/R_i + 1/R_j; an infinite radius_j is a plane of the same material.
/// Units: N from Pa and m. Valid for overlaps small against the radii.
/// Source: K. L. Johnson, Contact Mechanics (1985), Eqs. 4.20-4.24.
struct hertz {
  double young_modulus;  // E, Pa
  double poisson_ratio;  // nu, in (-1, 0.5]

  double contact_modulus() const { return young_modulus / (2.0 * (1.0 - poisson_ratio * poisson_ratio)); }

  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    const T radius = effective_radius(a);
    const T root = sqrt(T(radius * overlap));
    return T(4.0 / 3.0 * contact_modulus()) * root * overlap;
  }

  template <Scalar T>
  T stiffness(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    const T radius = effective_radius(a);
    const T root = sqrt(T(radius * overlap));
    return T(2.0 * contact_modulus()) * root;
  }

  /// Stored energy, J.
  template <Scalar T>
  T energy(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    const T force = repulsion(a);
    return T(0.4) * force * overlap;
  }

 private:
  template <Scalar T>
  static T effective_radius(const approach<T>& a) {
    const T curvature = T(1) / a.radius_i + T(1) / a.radius_j;
    return T(1) / curvature;
  }
};

inline void validate(const hertz& law) {
  constexpr auto page = "docs/reference/laws.md";
  expects(law.young_modulus > 0 && std::isfinite(law.young_modulus), "the Young modulus E (Pa)", law.young_modulus,
          "positive and finite", page);
  expects(law.poisson_ratio > -1 && law.poisson_ratio <= 0.5, "the Poisson ratio nu", law.poisson_ratio, "in (-1, 0.5]",
          page);
}

}  // namespace pendular::normal
