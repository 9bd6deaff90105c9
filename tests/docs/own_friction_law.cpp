// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/how-to/own_friction_law.md.
#include <pendular/pendular.hpp>
#include <pendular/testing/law_kits.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

// [law]
/// Tangential spring and dashpot side by side, together inside the Coulomb cone.
struct spring_and_dashpot {
  double tangential_stiffness;  // k_t, N/m
  double tangential_viscosity;  // gamma_t, N s/m
  double friction_coefficient;  // mu

  template <class T>
  struct contact_memory {
    pendular::Vec3<T> elastic_force;  // N, on grain i
  };

  template <pendular::Scalar T>
  pendular::Vec3<T> traction(const pendular::slip<T>& s, const T& normal_force, contact_memory<T>& memory) const {
    using pendular::Vec3, pendular::shortened_to;
    const T limit = T(friction_coefficient) * normal_force;
    const Vec3<T> stretched = memory.elastic_force - T(tangential_stiffness * s.time_step) * s.velocity;
    memory.elastic_force = shortened_to(stretched, limit);
    return shortened_to(Vec3<T>(memory.elastic_force - T(tangential_viscosity) * s.velocity), limit);
  }

  /// Energy stored in the spring, J.
  template <pendular::Scalar T>
  T energy(const contact_memory<T>& memory) const {
    return dot(memory.elastic_force, memory.elastic_force) / T(2.0 * tangential_stiffness);
  }
};

inline void validate(const spring_and_dashpot& law) {
  pendular::expects(law.tangential_stiffness > 0, "the tangential stiffness k_t (N/m)", law.tangential_stiffness,
                    "positive", "my_laws.md");
}

static_assert(pendular::check::friction_law<spring_and_dashpot>);
// [/law]

using namespace pendular;

// [slide]
/// A sphere that starts to slide at 0.1 m/s on a plane rolls at 5/7 of it in the end, whatever the friction law.
double rolling_speed() {
  const material m{normal::linear{1e3}, damping::viscous{0.8}, spring_and_dashpot{800, 1e-3, 0.4}};
  pendular::system s{m, boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                     velocity_verlet{2e-6, {0, 0, -9.81}}};
  s.add({.position = {0, 0, 0.5e-3}, .radius = 0.5e-3, .density = 2600, .velocity = {0.1, 0, 0}});
  s.run(40000);
  return s.particles().get<column::velocity>()[0].x;
}
// [/slide]

int main() {
  // [kit]
  for (const std::string& broken : testing::friction_law_report(spring_and_dashpot{800, 1e-3, 0.4}, 0.4)) {
    std::printf("%s\n", broken.c_str());
  }
  // [/kit]
  const bool sound = testing::friction_law_report(spring_and_dashpot{800, 1e-3, 0.4}, 0.4).empty();
  const double rolling = rolling_speed();
  std::printf("rolls at %.6f m/s\n", rolling);
  return sound && std::abs(rolling - 0.5 / 7) < 1e-3 * 0.1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
