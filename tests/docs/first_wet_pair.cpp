// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/tutorial/first_wet_pair.md.
// [head]
#include <pendular/pendular.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

using namespace pendular;

constexpr double radius = 0.5e-3;                                   // m
constexpr double bridge_volume = 0.01 * radius * radius * radius;  // m3
// [/head]

// [pair]
auto wet_pair(double speed) {
  pendular::system pair{material{normal::linear{1e3}},
                        liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}},
                        boundary::walls{}, velocity_verlet{1e-6}};
  pair.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  pair.add({.position = {2 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {speed, 0, 0}});
  pair.distribute_liquid(bridge_volume);
  return pair;
}
// [/pair]

// [escapes]
bool escapes(double speed) {
  auto pair = wet_pair(speed);
  pair.run(5000);
  return pair.bridges().count() == 0;
}
// [/escapes]

// [energy]
double energy_error(double speed) {
  pendular::system pair{material{normal::linear{1e3}, damping::viscous{0.8}, energy_book{}},
                        liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}},
                        boundary::walls{}, half_step_velocity_verlet{1e-6}};
  pair.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  pair.add({.position = {2 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {speed, 0, 0}});
  pair.distribute_liquid(bridge_volume);
  const observe::energies before = observe::energies_of(pair);
  pair.run(5000);
  const observe::energies after = observe::energies_of(pair);
  return std::abs(after.balance() - before.balance()) / before.kinetic;
}
// [/energy]

int main() {
  // [look]
  const auto pair = wet_pair(0);
  const double pull = norm(pair.contacts().force(0));                                            // N
  const double expected = 2 * std::numbers::pi * fluid::water().surface_tension * radius;        // N
  std::printf("gap %g m, bridges %zu, pull %.6e N, expected %.6e N\n", pair.view().gap(0), pair.bridges().count(), pull,
              expected);
  // [/look]

  // [try]
  double holds = 0.10, breaks = 0.25;  // m/s
  while (breaks - holds > 1e-5) {
    const double speed = 0.5 * (holds + breaks);
    (escapes(speed) ? breaks : holds) = speed;
  }
  std::printf("the bridge breaks above %.4f m/s\n", breaks);
  // [/try]

  // [liquid]
  auto broken = wet_pair(0.2);
  broken.run(5000);
  const ledger& book = broken.bridges().book();
  std::printf("films %.4e and %.4e m3, lost %.1e\n", book.films()[0], book.films()[1], book.total() / bridge_volume - 1);
  // [/liquid]

  const bool as_expected = std::abs(pull - expected) < 1e-12 * expected && std::abs(breaks - 0.16577) < 1e-4 &&
                           std::abs(book.films()[0] - 0.5 * bridge_volume) < 1e-12 * bridge_volume &&
                           energy_error(0.1) < 1e-3;
  return as_expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
