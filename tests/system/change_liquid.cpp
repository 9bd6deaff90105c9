// SPDX-License-Identifier: BSD-3-Clause
// Another fluid between two runs: what acts, breaks and is stored is that of the new one, and what does not fit changes
// nothing.
#include "../open/resumed.hpp"
#include "../physics/scenes.hpp"

#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/observe/energy.hpp>

using namespace pendular;

namespace {

constexpr double radius = 0.5e-3, volume = 1e-12, heavy = 1e12;  // grains too heavy to move
constexpr double tension = 0.072, angle = 0.5;

auto paper(double surface_tension, double contact_angle = angle) {
  return liquid{fluid{surface_tension, contact_angle, 998, 1e-3}, capillary::richefeu{}, rupture::lian{}};
}

/// Two grains of radii 1:2 with a bridge over a gap.
auto bridged_pair(double gap, const run_options& options = {.force = true}) {
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.1}, energy_book{}}, paper(tension),
                     boundary::walls{}, velocity_verlet{1e-7}, options};
  s.add({{0, 0, 0}, radius, heavy});
  s.add({{3 * radius + gap, 0, 0}, 2 * radius, heavy});
  s.distribute_liquid(volume);
  REQUIRE(s.bridges().count() == 1);
  return s;
}

}  // namespace

TEST_CASE("pull and stored energy of a bridge follow another surface tension at once, its volume stays") {
  auto s = bridged_pair(20e-6);
  const double pull = s.contacts().force(0).x;
  const auto before = observe::energies_of(s);
  REQUIRE(pull > 0);
  s.change_liquid(paper(2 * tension));
  CHECK(s.contacts().force(0).x == within(1e-14, 2 * pull));
  CHECK(s.particles().get<column::force>()[0].x == within(1e-14, 2 * pull));
  CHECK(s.bridges().book().bonds()[0] == within(1e-15, volume));
  const auto after = observe::energies_of(s);
  CHECK(after.capillary == within(1e-12, 2 * before.capillary));
  CHECK(after.balance() == near(1e-14 * std::abs(before.capillary), before.balance()));
  s.run(10);
  CHECK(s.contacts().force(0).x == within(1e-9, 2 * pull));
}

TEST_CASE("a bridge at a wall follows another fluid, too") {
  using boundary::plane;
  using boundary::wall;
  const auto water = [](double surface_tension) {
    return liquid{fluid{surface_tension, 0, 998, 1e-3}, capillary::bagheri{}, rupture::willett{}};
  };
  pendular::system s{
      material{normal::linear{1e3}}, water(tension),
      boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}}},
      velocity_verlet{1e-7}, run_options{.force = true}};
  s.add({{0, 0, radius + 20e-6}, radius, heavy});
  s.distribute_liquid(volume);
  const double pull = boundary::get<0>(s.walls()).force.z;
  REQUIRE(pull > 0);
  s.change_liquid(water(2 * tension));
  CHECK(boundary::get<0>(s.walls()).force.z == within(1e-14, 2 * pull));
  CHECK(s.particles().get<column::force>()[0].z == within(1e-14, -2 * pull));
}

TEST_CASE("bridges beyond the rupture distance of another fluid break, and their liquid stays on the grains") {
  // (1 + angle / 2) V^(1/3): 125 um before and 100 um after.
  auto s = bridged_pair(110e-6);
  CHECK(s.bridges().breaks_above(0) == within(1e-12, 125e-6));
  s.change_liquid(paper(tension, 0));
  CHECK(s.bridges().count() == 0);
  CHECK(s.events().ruptures == 1);
  CHECK(s.bridges().book().films()[0] == within(1e-12, volume / 3));
  CHECK(s.bridges().book().films()[1] == within(1e-12, volume * 2 / 3));
  s.run(1);
  CHECK(s.contacts().force(0) == vector{0, 0, 0});
}

TEST_CASE("a fluid that a limit refuses, or that is none, has changed nothing") {
  auto s = bridged_pair(20e-6, {});
  const vector pull = s.contacts().force(0);
  CHECK_THROWS_WITH(s.change_liquid(paper(20 * tension)), Catch::Contains("capillary force"));
  CHECK_THROWS_AS(paper(-1), input_error);
  CHECK(s.contacts().force(0) == pull);
  CHECK(s.bridges().policies().substance().surface_tension == tension);
  CHECK(s.bridges().work() == bridged_pair(20e-6, {}).bridges().work());
}

TEST_CASE("a bridge that another fluid takes out of the validity of its laws is counted once more") {
  auto s = bridged_pair(20e-6);
  REQUIRE(s.bridges().outside().rupture_law == 0);
  s.change_liquid(paper(tension, 1.1));  // valid up to 1.0472
  CHECK(s.bridges().outside().rupture_law == 1);
  CHECK(s.bridges().outside().capillary_law == 0);
}

TEST_CASE("how many bridges were made beyond the validity of each law is kept over a resume") {
  auto s = bridged_pair(20e-6);
  s.change_liquid(paper(tension, 1.1));
  REQUIRE((s.bridges().outside().capillary_law == 0 && s.bridges().outside().rupture_law == 1));
  const auto again = resumed(s, pendular::system{s.contact_material(), s.bridges().policies(), s.walls(),
                                                 s.integrator(), run_options{.force = true}});
  CHECK(again.bridges().outside().capillary_law == 0);
  CHECK(again.bridges().outside().rupture_law == 1);
}
