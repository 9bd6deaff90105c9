// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/damping/viscous.hpp>

namespace pendular::damping {

/// Dashpot acting in contact and on approach only, f_d = 2 alpha_n sqrt(m k) max(closing_speed, 0) for delta_n < 0.
/// Units: N from kg, N/m, m/s; k is the tangent stiffness of the normal law. Valid for alpha_n in [0, 1].
/// A linear spring gives restitution exp(-alpha arccos(alpha) / sqrt(1 - alpha^2)), never below 1/e.
/// Source: Richefeu et al. 2007, Eq. 3 as printed (condition on the rate), with its sign turned so that it dissipates.
struct viscous_on_approach {
  double damping_rate;  // alpha_n

  template <Scalar T>
  prepared_dashpot<T> prepare(const T& reduced_mass, const T& stiffness) const {
    return viscous{damping_rate}.prepare(reduced_mass, stiffness);
  }
  /// From the stiffness or from what was prepared.
  template <Scalar T, class StiffnessOrDashpot>
  T resistance(approach<T> a, const StiffnessOrDashpot& known) const {
    a.closing_speed = max(a.closing_speed, T(0));
    return viscous{damping_rate}.resistance(a, known);
  }
};

inline void validate(const viscous_on_approach& law) {
  expects(law.damping_rate >= 0 && law.damping_rate <= 1, "the damping rate alpha_n", law.damping_rate,
          "in [0, 1], where 1 is the critical damping 2 sqrt(m k_n)", "docs/reference/laws.md");
}

}  // namespace pendular::damping
