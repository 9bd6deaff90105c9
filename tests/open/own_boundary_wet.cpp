// SPDX-License-Identifier: BSD-3-Clause
// A boundary of a user's own with a side that carries bridges.
#include "box_of_sides.hpp"
#include "resumed.hpp"

#include <pendular/law/capillary/constant.hpp>
#include <pendular/law/rupture/willett.hpp>

using namespace sides;

namespace {
auto wet_sides() { return sides_of(boundary::wettable{}, none{}); }

template <class Walls>
auto wet_scene(const Walls& walls) {
  return pendular::system{material{normal::linear{k_n}, damping::viscous{0.3}},
                          liquid{fluid::water(), capillary::constant{}, rupture::willett{}}, walls,
                          velocity_verlet{1e-6, {0, 0, -g}}};
}
}  // namespace

TEST_CASE("a wettable part carries a bridge that pulls its grain in by Derjaguin's force") {
  auto s = wet_scene(wet_sides());
  s.add({.position = {3e-3, 3e-3, radius}, .radius = radius, .density = density});
  s.distribute_liquid(1e-12);
  CHECK(s.bridges().count() == 1);
  s.run(4000);
  const double pull = 4 * std::numbers::pi * 0.0728 * radius;  // sphere and plane, Derjaguin 1934
  CHECK(radius - s.particles()[0].position.z == within(1e-6, (mass * g + pull) / k_n));
  CHECK(s.walls().floor.force.z == within(1e-6, -mass * g));
}

TEST_CASE("a wet boundary of one's own goes on with the same bits after a resume") {
  auto s = wet_scene(wet_sides());
  fill(s);
  s.distribute_liquid(5e-12);
  check_resume(s, wet_scene(wet_sides()), 2500, [](const auto& seen) { return all_that_is_kept(seen); });
  CHECK(s.walls().lid.load.hardest > 0);
}
