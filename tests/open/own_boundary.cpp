// SPDX-License-Identifier: BSD-3-Clause
// A boundary of a user's own: what grains and observers see of it.
#include "box_of_sides.hpp"

#include <pendular/observe/energy.hpp>

using namespace sides;

static_assert(boundary::Boundary<boundary::walls<>> && boundary::Boundary<boundary::walls<wall<plane>>>);
static_assert(!boundary::Boundary<wall<plane>> && !boundary::Boundary<velocity_verlet>);

TEST_CASE("a grain comes to rest m g / k deep in the floor of a boundary of one's own") {
  auto s = dry_scene(dry_sides());
  s.add({.position = {3e-3, 3e-3, radius}, .radius = radius, .density = density});
  s.run(4000);
  const double overlap = mass * g / k_n;
  CHECK(radius - s.particles()[0].position.z == within(1e-6, overlap));
  CHECK(s.walls().floor.force.z == within(1e-6, -mass * g));
  CHECK(norm(s.walls().left.force) == 0);
  CHECK(observe::energies_of(s).elastic == within(1e-5, 0.5 * mass * g * overlap));
}

TEST_CASE("a wall of one's own is told how hard it is hit: twice the weight by a grain let go where it touches") {
  auto s = dry_scene(dry_sides(), 0, g);  // gravity upwards
  s.add({.position = {3e-3, 3e-3, side - radius}, .radius = radius, .density = density});
  s.run(1000);
  CHECK(s.walls().lid.load.hardest == within(1e-3, 2 * mass * g));
}

TEST_CASE("a moving part comes in time: a grain away from it is hit to twice its speed") {
  auto s = dry_scene(dry_sides(), 0, 0);
  s.walls().floor.drive.velocity = {0, 0, 0.1};
  s.add({.position = {3e-3, 3e-3, 1.5e-3}, .radius = radius, .density = density});
  s.run(12000);
  CHECK(s.particles()[0].velocity.z == within(1e-3, 0.2));
  CHECK(s.walls().floor.work == within(1e-3, 0.5 * mass * 0.2 * 0.2));
}

TEST_CASE("limits see the parts: a stiffer side shortens the step of the grain that is near it") {
  const auto squared_frequency = [](double stiffness) {               // 1/s2, of a step of 2 / omega
    auto s = dry_scene(dry_sides(grains_of(stiffness, 0, 1e-6)), 0);  // next to no friction spring
    s.add({.position = {side - radius, 3e-3, 3e-3}, .radius = radius, .density = density});
    return std::pow(2 / s.limits().front().bound, 2);
  };
  // omega^2 is twice the largest stiffness over the mass (docs/reference/integrators.md)
  CHECK(squared_frequency(4 * k_n) - squared_frequency(k_n) == within(1e-6, 2 * 3 * k_n / mass));
}
