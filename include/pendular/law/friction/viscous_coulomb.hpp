// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::friction {

/// Viscous-regularised Coulomb friction that is stable at any time step,
///     f_t = -min(gamma_t |v|, mu N) v / |v|   as the time step goes to 0.
/// At a finite step the dashpot gamma_t acts in series with a numerical spring and dashpot side by side,
///     k = spring_share m / dt^2,  eta = dashpot_share m / dt,  m = tangential_mass / contacts.
/// Steady slip takes exactly gamma_t |v| at every step, because the numerical element then no longer moves, and no slip
/// rate is amplified: m bounds every tangential mode of a packing (docs/explanation/friction.md).
/// Units: N from N s/m, m/s, N. Valid for any gamma_t and step that resolves the elastic contact.
/// Source: Richefeu et al. 2007, Eq. 12; the time discretisation is this library's.
struct viscous_coulomb {
  double tangential_viscosity;  // gamma_t, N s/m
  double friction_coefficient;  // mu

  static constexpr bool counts_contacts = true;
  // Critical damping of the stiffest mode with half of the stability limit of synchronised velocities left over.
  static constexpr double spring_share = 0.0625;
  static constexpr double dashpot_share = 0.5;

  template <class T>
  struct contact_memory {
    Vec3<T> elastic_force;  // of the numerical spring, N
  };

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force, contact_memory<T>& memory) const {
    const T mass_rate = s.tangential_mass / (s.contacts * T(s.time_step));
    const T viscosity = T(tangential_viscosity);
    const T resistance = T(spring_share + dashpot_share) * mass_rate;
    const T weight = viscosity / (viscosity + resistance);
    const T limit = T(friction_coefficient) * normal_force;

    const Vec3<T> trial = weight * (memory.elastic_force - resistance * s.velocity);
    const T slip_share = T(1) / viscosity;
    const Vec3<T> elastic_velocity = s.velocity + slip_share * trial;
    const T spring_rate = T(spring_share) * mass_rate;
    memory.elastic_force = shortened_to(Vec3<T>(memory.elastic_force - spring_rate * elastic_velocity), limit);
    return shortened_to(trial, limit);
  }
};

inline void validate(const viscous_coulomb& law) {
  constexpr auto page = "docs/reference/laws.md";
  expects(law.tangential_viscosity > 0 && std::isfinite(law.tangential_viscosity),
          "the tangential viscosity gamma_t (N s/m)", law.tangential_viscosity, "positive and finite", page);
  expects(law.friction_coefficient >= 0 && std::isfinite(law.friction_coefficient), "the friction coefficient mu",
          law.friction_coefficient, "at least 0 and finite", page);
}

}  // namespace pendular::friction
