// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::friction {

/// Tangential spring with a Coulomb limit: the spring force follows -k_t times the slip since first touch and is cut to
/// mu N, so that a contact at rest carries a static force. Whoever keeps the memory turns it with the contact
/// (contact/force.hpp does).
/// Units: N from N/m, m/s, s. Valid while k_t dt^2 is small against the tangential mass.
/// Source: Cundall and Strack 1979, Geotechnique 29, 47.
struct coulomb_spring {
  double tangential_stiffness;  // k_t, N/m
  double friction_coefficient;  // mu

  template <class T>
  struct contact_memory {
    Vec3<T> elastic_force;  // N, on grain i
  };

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force, contact_memory<T>& memory) const {
    const T impulse_stiffness = T(tangential_stiffness * s.time_step);
    const Vec3<T> trial = memory.elastic_force - impulse_stiffness * s.velocity;
    memory.elastic_force = shortened_to(trial, T(T(friction_coefficient) * normal_force));
    return memory.elastic_force;
  }

  /// Energy stored in the spring, J.
  template <Scalar T>
  T energy(const contact_memory<T>& memory) const {
    return dot(memory.elastic_force, memory.elastic_force) / T(2.0 * tangential_stiffness);
  }
};

inline void validate(const coulomb_spring& law) {
  constexpr auto page = "docs/reference/laws.md";
  expects(law.tangential_stiffness > 0 && std::isfinite(law.tangential_stiffness), "the tangential stiffness k_t (N/m)",
          law.tangential_stiffness, "positive and finite", page);
  expects(law.friction_coefficient >= 0 && std::isfinite(law.friction_coefficient), "the friction coefficient mu",
          law.friction_coefficient, "at least 0 and finite", page);
}

}  // namespace pendular::friction
