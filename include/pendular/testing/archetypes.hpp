// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

namespace pendular::testing::archetype {

// The least a concept asks for: no default constructor, no comparison, no parameter that can be seen, no optional
// member. Code that compiles with these uses nothing that the concept does not promise.

class normal_law {
 public:
  explicit normal_law(double normal_stiffness) : stiffness_of_spring(normal_stiffness) {}

  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    return T(stiffness_of_spring) * max(T(-a.gap), T(0));
  }

 private:
  double stiffness_of_spring;  // N/m
};

class damping_law {
 public:
  explicit damping_law(double damping) : viscosity(damping) {}

  template <Scalar T>
  T resistance(const approach<T>& a, const T&) const {
    return T(viscosity) * a.closing_speed * unit_step(T(-a.gap));
  }

 private:
  double viscosity;  // N s/m
};

class damping_law_beside_spring {
 public:
  explicit damping_law_beside_spring(double damping) : viscosity(damping) {}

  template <Scalar T>
  T resistance(const approach<T>& a, const elastic<T>& spring) const {
    return T(viscosity) * spring.push * a.closing_speed;
  }

 private:
  double viscosity;  // s/m
};

class damping_law_with_memory {
 public:
  explicit damping_law_with_memory(double damping) : viscosity(damping) {}

  template <class T>
  struct contact_memory {
    T fastest;  // m/s
  };

  template <Scalar T>
  T resistance(const approach<T>& a, const T&, contact_memory<T>& memory) const {
    memory.fastest = unit_step(T(-a.gap)) * max(memory.fastest, a.closing_speed);
    return T(viscosity) * memory.fastest * a.closing_speed;
  }

 private:
  double viscosity;  // N s2/m2
};

class normal_law_with_memory {
 public:
  explicit normal_law_with_memory(double normal_stiffness) : stiffness_of_spring(normal_stiffness) {}

  template <class T>
  struct contact_memory {
    T deepest;  // m
  };

  template <Scalar T>
  T repulsion(const approach<T>& a, contact_memory<T>& memory) const {
    const T overlap = max(T(-a.gap), T(0));
    memory.deepest = unit_step(overlap) * max(memory.deepest, overlap);
    return max(T(T(stiffness_of_spring) * (T(2) * overlap - memory.deepest)), T(0));
  }

 private:
  double stiffness_of_spring;  // N/m
};

class friction_law {
 public:
  explicit friction_law(double friction_coefficient) : coefficient(friction_coefficient) {}

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force) const {
    return shortened_to(Vec3<T>(-s.velocity), T(T(coefficient) * normal_force));
  }

 private:
  double coefficient;  // mu
};

class friction_law_with_memory {
 public:
  explicit friction_law_with_memory(double friction_coefficient) : coefficient(friction_coefficient) {}

  template <class T>
  struct contact_memory {
    Vec3<T> displacement;  // m
  };

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force, contact_memory<T>& memory) const {
    memory.displacement -= T(s.time_step) * s.velocity;
    return shortened_to(memory.displacement, T(T(coefficient) * normal_force));
  }

 private:
  double coefficient;  // mu
};

class capillary_law {
 public:
  explicit capillary_law(double share_of_tension) : share(share_of_tension) {}

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return T(share * f.surface_tension) * (b.radius_i + b.radius_j);
  }

 private:
  double share;
};

class prepared_capillary_law {
 public:
  explicit prepared_capillary_law(double share_of_tension) : share(share_of_tension) {}

  template <class T>
  struct coefficients {
    T force;
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    return {T(share * f.surface_tension) * (b.radius_i + b.radius_j)};
  }

  template <Scalar T>
  T attraction(const T&, const coefficients<T>& c) const {
    return c.force;
  }

 private:
  double share;
};

class mean_radius {
 public:
  explicit mean_radius(double share_of_first) : share(share_of_first) {}

  template <Scalar T>
  T of(const bridge<T>& b) const {
    return T(share) * (b.radius_i + b.radius_j);
  }

 private:
  double share;
};

class rupture_law {
 public:
  explicit rupture_law(double share_of_length) : share(share_of_length) {}

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid&) const {
    return T(share) * cbrt(b.volume);
  }

 private:
  double share;
};

class viscous_bridge_law {
 public:
  explicit viscous_bridge_law(double share_of_viscosity) : share(share_of_viscosity) {}

  template <Scalar T>
  bridge_resistance<T> resistance(const bridge<T>& b, const fluid& f) const {
    const T whole = T(share * f.viscosity) * cbrt(b.volume);
    return {whole, T(0.5) * whole};
  }

 private:
  double share;
};

}  // namespace pendular::testing::archetype
