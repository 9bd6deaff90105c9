// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/tutorial/your_own_law.md.
// [law]
#include <pendular/pendular.hpp>

#include <numbers>

/// Capillary force of Willett et al. 2000, Langmuir 16, 9396, in its closed form:
///     F = 2 pi R_h gamma_s cos(theta) / (1 + 1.05 S + 2.5 S^2),  S = gap sqrt(R_h / V_b),  R_h = 2 R_i R_j / (R_i + R_j).
struct my_bridge {
  template <pendular::Scalar T>
  T attraction(const pendular::bridge<T>& b, const pendular::fluid& f) const {
    const T radius = T(2) * b.radius_i * b.radius_j / (b.radius_i + b.radius_j);
    const T open = pendular::max(b.gap, T(0));
    const T volume = pendular::max(b.volume, T(pendular::tiny));  // a dry pair must not divide 0 by 0
    const T s = open * pendular::sqrt(T(radius / volume));
    return T(pendular::capillary_tension(f)) * radius / (T(1) + T(1.05) * s + T(2.5) * s * s);
  }
};
// [/law]

// [check]
#include <pendular/law/check.hpp>

static_assert(pendular::check::capillary_law<my_bridge>);
// [/check]

// [kit]
#include <pendular/testing/law_kits.hpp>

#include <cstdio>

bool keeps_its_promises() {
  const auto broken = pendular::testing::capillary_law_report(my_bridge{}, pendular::fluid::water());
  for (const std::string& sentence : broken) std::printf("%s\n", sentence.c_str());
  return broken.empty();
}
// [/kit]

#include <cmath>
#include <cstdlib>
#include <string>

// [run]
using namespace pendular;

template <class Law>
double escape_speed(const Law& law) {
  constexpr double radius = 0.5e-3, volume = 0.01 * radius * radius * radius;
  double holds = 0.05, breaks = 0.5;  // m/s
  while (breaks - holds > 1e-4) {
    const double speed = 0.5 * (holds + breaks);
    pendular::system pair{material{normal::linear{1e3}},
                          liquid{fluid::water(), law, rupture::willett{}, protocol::grain_films{}}, boundary::walls{},
                          velocity_verlet{1e-6}};
    pair.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
    pair.add({.position = {2 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {speed, 0, 0}});
    pair.distribute_liquid(volume);
    pair.run(5000);
    (pair.bridges().count() == 0 ? breaks : holds) = speed;
  }
  return breaks;
}
// [/run]

// [prepared]
struct my_prepared_bridge {
  template <class T>
  struct coefficients {
    T contact_force;  // N
    T curvature;      // S per gap, 1/m
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = T(2) * b.radius_i * b.radius_j / (b.radius_i + b.radius_j);
    const T volume = pendular::max(b.volume, T(tiny));
    return {T(capillary_tension(f)) * radius, pendular::sqrt(T(radius / volume))};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    const T s = pendular::max(gap, T(0)) * c.curvature;
    return c.contact_force / (T(1) + T(1.05) * s + T(2.5) * s * s);
  }
};
static_assert(check::capillary_law<my_prepared_bridge>);
// [/prepared]

int main() {
  const double of_richefeu = escape_speed(capillary::richefeu{}), mine = escape_speed(my_bridge{});
  std::printf("escape speed %.4f m/s with Richefeu's law, %.4f m/s with mine\n", of_richefeu, mine);
  const bool same = std::abs(mine - escape_speed(my_prepared_bridge{})) < 1e-12;
  const bool sound = keeps_its_promises() &&
                     testing::capillary_law_report(my_prepared_bridge{}, fluid::water()).empty();
  return sound && same && mine < of_richefeu && mine > 0.85 * of_richefeu ? EXIT_SUCCESS : EXIT_FAILURE;
}
