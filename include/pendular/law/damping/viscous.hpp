// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::damping {

/// Two-sided dashpot acting in contact, f_d = 2 alpha_n sqrt(m k) closing_speed for delta_n < 0, else 0.
/// Units: N from kg, N/m, m/s; k is the tangent stiffness of the normal law. Valid for alpha_n in [0, 1]; 1 is critical.
/// A linear spring ends the contact at delta_n = 0 with restitution exp(-pi alpha / sqrt(1 - alpha^2)).
/// Source: Richefeu et al. 2007, Eq. 3, with its sign turned so that it dissipates, and with the condition on the gap
/// as in Richefeu et al. 2006 (Eur. Phys. J. E 21, 359), Eq. 3.
struct viscous {
  double damping_rate;  // alpha_n

  template <Scalar T>
  T resistance(const approach<T>& a, const T& stiffness) const {
    return resistance(a, prepare(a.reduced_mass, stiffness));
  }

  template <Scalar T>
  prepared_dashpot<T> prepare(const T& reduced_mass, const T& stiffness) const {
    const T root = sqrt(T(reduced_mass * stiffness));
    return {T(2.0 * damping_rate) * root};
  }
  template <Scalar T>
  T resistance(const approach<T>& a, const prepared_dashpot<T>& made) const {
    const T touching = unit_step(T(-a.gap));
    return made.coefficient * a.closing_speed * touching;
  }
};

inline void validate(const viscous& law) {
  expects(law.damping_rate >= 0 && law.damping_rate <= 1, "the damping rate alpha_n", law.damping_rate,
          "in [0, 1], where 1 is the critical damping 2 sqrt(m k_n)", "docs/reference/laws.md");
}

}  // namespace pendular::damping
