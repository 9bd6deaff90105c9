// SPDX-License-Identifier: BSD-3-Clause
// Two wet grains that meet in a viscous liquid: their motion against an integration of the pair alone, their energy, and
// the time step they need.
#include "../catch.hpp"

#include <pendular/observe/energy.hpp>
#include <pendular/pendular.hpp>

#include <algorithm>

using namespace pendular;

namespace {
constexpr double radius = 1e-3, volume = 1e-11, density = 2600, gap = 2e-5;
constexpr double viscosity = 0.1;
constexpr fluid oil{1e-9, 0, 900, viscosity};  // all but no surface tension

auto meeting(double speed, double sideways, double step, bool force = false) {
  pendular::system pair{material{normal::linear{1}, friction::coulomb_spring{0.8, 0.0}, energy_book{}},
                        liquid{oil, capillary::constant{}, rupture::lian{}, viscous::lubrication{1e-2}},
                        boundary::walls{}, velocity_verlet{step}, run_options{.force = force}};
  pair.add({.position = {0, 0, 0}, .radius = radius, .density = density, .velocity = {0.5 * speed, 0.5 * sideways, 0}});
  pair.add({.position = {2 * radius + gap, 0, 0},
            .radius = radius,
            .density = density,
            .velocity = {-0.5 * speed, -0.5 * sideways, 0}});
  pair.distribute_liquid(volume);
  return pair;
}

double mass() { return density * 4.0 / 3 * std::numbers::pi * radius * radius * radius; }
}  // namespace

TEST_CASE("grains that close on each other slow down as the film says") {
  auto pair = meeting(0.02, 0, 1e-7);
  pair.run(4000);
  // dD/dt = -v, dv/dt = -(6 pi eta R*^2 / D) filled^2 v / m_red, by midpoint steps of a nanosecond
  double d = gap, v = 0.02;
  const double reduced = mass() / 2;
  const auto rate = [&](double at) {
    const double film = std::max(at, 1e-2 * radius / 2),
                 filled = 1 - 1 / std::sqrt(1 + 2 * volume / (std::numbers::pi * radius * film * film));
    return 6 * std::numbers::pi * viscosity * radius * radius / 4 / film * filled * filled / reduced;
  };
  for (int k = 0; k < 400000; ++k) {
    const double h = 1e-9, middle_v = v - 0.5 * h * rate(d) * v, middle_d = d - 0.5 * h * v;
    v -= h * rate(middle_d) * middle_v;
    d -= h * middle_v;
  }
  CHECK((v < 0.018 && v > 0.005));
  CHECK(pair.view().gap(0) == near(2e-9, d));
  const auto velocity = pair.particles().get<column::velocity>();
  CHECK(norm(velocity[0] - velocity[1]) == within(2e-3, v));
}

TEST_CASE("what the film takes stands in the energy book, sliding included") {
  auto pair = meeting(0.01, 0.02, 1e-7);
  const auto start = observe::energies_of(pair);
  const double before = start.kinetic;
  pair.run(3000);
  const auto after = observe::energies_of(pair);
  CHECK(after.kinetic < 0.8 * before);
  CHECK(after.damping > 0.01 * before);
  CHECK(after.friction > 0.01 * before);
  CHECK(std::abs(after.balance() - start.balance()) < 1e-3 * before);
  // grains that slide over a film begin to roll, both the same way
  const auto spin = pair.particles().get<column::angular_velocity>();
  CHECK(spin[0].z < -0.1);
  CHECK(spin[1].z == within(1e-9, spin[0].z));
}

TEST_CASE("a step too long for the film is refused") {
  CHECK_NOTHROW(meeting(0, 0, 2e-6));
  CHECK_THROWS_WITH(meeting(0, 0, 1e-3), Catch::Matchers::Contains("viscosity of the bridges"));
  CHECK_NOTHROW(meeting(0, 0, 1e-3, true));
}

TEST_CASE("a grain feels the films of all its bridges: two neighbours halve the step of one") {
  const auto longest = [](int grains) {
    auto s = meeting(0, 0, 1e-7, true);
    if (grains == 3) {
      s.add({.position = {2 * (2 * radius + gap), 0, 0}, .radius = radius, .density = density});
      s.distribute_liquid(volume);  // as much for the second bridge
    }
    for (const scene_limit& l : s.limits()) {
      if (l.what.find("viscosity of the bridges") != std::string::npos) return l.bound;
    }
    return 0.0;
  };
  REQUIRE(longest(2) > 0);
  CHECK(longest(3) == within(1e-9, 0.5 * longest(2)));
}
