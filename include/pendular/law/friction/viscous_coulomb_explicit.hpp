// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::friction {

/// Viscous-regularised Coulomb friction in the published explicit form,
///     f_t = -min(gamma_t |v|, mu N) v / |v|.
/// Units: N from N s/m, m/s, N. Valid while gamma_t dt < 2 m_t / n at every contact (m_t = 2/7 reduced mass, n touching
/// neighbours): beyond that bound the law alternates in sign from step to step and is held only by its Coulomb cap.
/// At the 1 N s/m and 1e-6 s of Richefeu et al. 2006 it is beyond that bound for grains of 1 mm.
/// Source: Richefeu et al. 2007, Eq. 12.
struct viscous_coulomb_explicit {
  double tangential_viscosity;  // gamma_t, N s/m
  double friction_coefficient;  // mu

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force) const {
    const Vec3<T> viscous_force = T(-tangential_viscosity) * s.velocity;
    return shortened_to(viscous_force, T(T(friction_coefficient) * normal_force));
  }
};

inline void validate(const viscous_coulomb_explicit& law) {
  constexpr auto page = "docs/reference/laws.md";
  expects(law.tangential_viscosity > 0 && std::isfinite(law.tangential_viscosity),
          "the tangential viscosity gamma_t (N s/m)", law.tangential_viscosity, "positive and finite", page);
  expects(law.friction_coefficient >= 0 && std::isfinite(law.friction_coefficient), "the friction coefficient mu",
          law.friction_coefficient, "at least 0 and finite", page);
}

}  // namespace pendular::friction
