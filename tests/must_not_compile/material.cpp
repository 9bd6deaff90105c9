// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a material needs exactly one normal law, such as normal::linear{1e3}
// expect 2: a material needs exactly one normal law, such as normal::linear{1e3}
// expect 3: a material takes at most one friction law
// expect 4: a material takes at most one damping law
// expect 5: every policy of a material must be a normal, damping or friction law, energy_book or none
// expect 6: a normal law must take every scalar, not double alone
// expect 7: a damping law must take every scalar, not double alone
// expect 8: a friction law must take every scalar, not double alone
#include <pendular/contact/material.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/damping/viscous_on_approach.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>

using namespace pendular;

struct spring {
#if PENDULAR_MISTAKE == 6
  double repulsion(const approach<double>& a) const { return max(-1e3 * a.gap, 0.0); }
#else
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    return T(1e3) * max(T(-a.gap), T(0));
  }
#endif
};
struct dashpot {
#if PENDULAR_MISTAKE == 7
  double resistance(const approach<double>& a, double) const { return a.closing_speed * unit_step(-a.gap); }
#else
  template <Scalar T>
  T resistance(const approach<T>& a, const T&) const {
    return a.closing_speed * unit_step(T(-a.gap));
  }
#endif
};
struct slider {
#if PENDULAR_MISTAKE == 8
  Vec3<double> traction(const slip<double>& s, double n) const { return shortened_to(-s.velocity, 0.4 * n); }
#else
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& n) const {
    return shortened_to(Vec3<T>(-s.velocity), T(T(0.4) * n));
  }
#endif
};
const material own{spring{}, dashpot{}, slider{}};

double stiffness_of_glass() {
#if PENDULAR_MISTAKE == 1
  const material glass{damping::viscous{0.8}, friction::coulomb_spring{800, 0.4}};
#elif PENDULAR_MISTAKE == 2
  const material glass{normal::linear{1e3}, normal::hertz{70e9, 0.22}};
#elif PENDULAR_MISTAKE == 3
  const material glass{normal::linear{1e3}, friction::coulomb_spring{800, 0.4}, friction::viscous_coulomb{1, 0.4}};
#elif PENDULAR_MISTAKE == 4
  const material glass{normal::linear{1e3}, damping::viscous{0.8}, damping::viscous_on_approach{0.8}};
#elif PENDULAR_MISTAKE == 5
  const material glass{normal::linear{1e3}, rupture::lian{}};
#else
  const material glass{damping::viscous{0.8}, friction::coulomb_spring{800, 0.4}, normal::linear{1e3}};
#endif
  return glass.normal().normal_stiffness;
}
