// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::damping {

/// Dashpot acting in contact and on approach only, f_d = 2 alpha_n sqrt(m k) max(closing_speed, 0) for delta_n < 0.
/// Units: N from kg, N/m, m/s; k is the tangent stiffness of the normal law. Valid for alpha_n in [0, 1].
/// A linear spring gives restitution exp(-alpha arccos(alpha) / sqrt(1 - alpha^2)), never below 1/e.
/// Source: Richefeu et al. 2007, Eq. 3 as printed (condition on the rate), with its sign turned so that it dissipates.
struct viscous_on_approach {
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
    return made.coefficient * max(a.closing_speed, T(0)) * touching;
  }
};

inline void validate(const viscous_on_approach& law) {
  expects(law.damping_rate >= 0 && law.damping_rate <= 1, "the damping rate alpha_n", law.damping_rate,
          "in [0, 1], where 1 is the critical damping 2 sqrt(m k_n)", "docs/reference/laws.md");
}

}  // namespace pendular::damping
