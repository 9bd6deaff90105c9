// SPDX-License-Identifier: BSD-3-Clause
// Bridges between grains and walls: force against the solution of Laplace-Young for a sphere and a plane, and everything
// that liquid does between grains done at a wall.
#include "../open/resumed.hpp"
#include "../physics/scenes.hpp"

#include <pendular/io/system_state.hpp>
#include <pendular/laplace_young/law.hpp>
#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/capillary/constant.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/law/viscous/lubrication.hpp>

#include <algorithm>

using namespace pendular;
using namespace scenes;
using boundary::plane;
using boundary::wall;

namespace {
constexpr double radius = 1e-3, cube = radius * radius * radius, tension = 0.072;
constexpr fluid water{tension, 0, 998.2, 1e-3};

auto wet_floor() {
  return boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}}};
}

auto glass(const auto&... policies) { return liquid{water, capillary::bagheri{}, rupture::willett{}, policies...}; }

/// One grain whose lowest point is `gap` above a wet floor. So heavy and slow that it stays there.
auto above_floor(double gap, double volume) {
  pendular::system s{material{normal::linear{1e3}},
                     liquid{water, capillary::laplace_young{water}, rupture::laplace_young{water}}, wet_floor(),
                     velocity_verlet{1e-12}, run_options{.skin = 1, .force = true}};
  s.add({.position = {0, 0, radius + gap}, .radius = radius, .density = 1e9});
  s.distribute_liquid(volume);
  return s;
}
}  // namespace

TEST_CASE("a wet floor pulls as an integration of Laplace-Young between a sphere and a plane has it") {
  // F / (2 pi R gamma) at the given part of D_r / R, perfect wetting; integrated independently (ODE, 0.1 %)
  struct row {
    double volume, farthest, at_0, at_1, at_25, at_50, at_75;
  };
  for (const row& r : {row{1e-3, 0.0992, 1.9204, 1.0269, 0.4028, 0.1425, 0.0728},
                       row{1e-2, 0.2075, 1.8512, 1.2739, 0.6772, 0.2882, 0.1559},
                       row{1e-1, 0.4170, 1.7135, 1.4131, 0.9924, 0.5483, 0.3287}}) {
    const double parts[] = {0, 0.1, 0.25, 0.5, 0.75}, forces[] = {r.at_0, r.at_1, r.at_25, r.at_50, r.at_75};
    for (int k = 0; k < 5; ++k) {
      const auto s = above_floor(parts[k] * r.farthest * radius, r.volume * cube);
      REQUIRE(s.bridges().count() == 1);
      const double pull = -s.particles().get<column::force>()[0].z / (2 * pi * radius * tension);
      CAPTURE(r.volume, parts[k]);
      CHECK(pull == within(4e-3, forces[k]));
      CHECK(boundary::get<0>(s.walls()).force.z == -s.particles().get<column::force>()[0].z);
      CHECK(s.bridges().breaks_above(s.view().first.size()) == within(4e-3, r.farthest * radius));
    }
  }
}

TEST_CASE("a grain hangs from a wet ceiling as long as it is lighter than the pull") {
  // rho (4/3) pi R^3 g = 1.8512 2 pi R gamma for V = 0.01 R^3
  const double heaviest = std::sqrt(1.5 * 1.8512 * tension / (2600 * 9.81));
  const auto hangs = [&](double r) {
    pendular::system s{
        material{normal::linear{1e3}, damping::viscous{0.5}},
        liquid{water, capillary::laplace_young{water}, rupture::laplace_young{water}},
        boundary::walls{wall{plane{{0, 0, 0}, {0, 0, -1}}, boundary::fixed{}, none{}, boundary::wettable{}}},
        velocity_verlet{1e-5, {0, 0, -9.81}}};
    s.add({.position = {0, 0, -r}, .radius = r, .density = 2600});
    s.distribute_liquid(0.01 * r * r * r);
    s.run(20000);
    return s.bridges().count() == 1;
  };
  CHECK(hangs(0.99 * heaviest));
  CHECK_FALSE(hangs(1.01 * heaviest));
}

TEST_CASE("a bridge at a wall gets the share of one between equal grains, and gives it back to its grain") {
  pendular::system s{material{normal::linear{1e3}}, glass(), wet_floor(), velocity_verlet{1e-7},
                     run_options{.force = true}};
  s.add({.position = {0, 0, radius}, .radius = radius, .density = 2600});
  s.add({.position = {2 * radius, 0, radius}, .radius = radius, .density = 2600});
  s.add({.position = {9 * radius, 0, 2 * radius}, .radius = 2 * radius, .density = 2600});
  s.distribute_liquid(0.11 * cube);  // 0.01 (1 + 1 + 1 + 8) R^3
  const auto view = s.view();
  REQUIRE(s.bridges().count() == 4);
  view.for_each_row([&](std::size_t p) {
    const double size = view.radius[view.grain_i(p)] / radius;
    if (s.bridges().is_bonded(p))
      CHECK(s.bridges().book().bonds()[p] == within(1e-13, 0.01 * size * size * size * cube));
  });
  for (vector& v : s.particles().get<column::velocity>()) v = {0, 0, 5};  // both small grains together
  s.run(1500);
  CHECK(s.events().ruptures == 3);
  CHECK(s.bridges().count() == 1);
  for (const std::int64_t id : {0, 1}) CHECK(s.bridges().book().films()[row_of(s, id)] == within(1e-12, 0.01 * cube));
  CHECK(s.bridges().book().films()[row_of(s, 2)] == within(1e-12, 0.08 * cube));
}

namespace {
/// As closed_box, wet at its floor, its lid and one side.
auto wet_box(double side) {
  const boundary::fixed still;
  const boundary::wettable wet;
  return boundary::walls{wall{plane{{0, 0, 0}, {1, 0, 0}}},
                         wall{plane{{side, 0, 0}, {-1, 0, 0}}, still, none{}, wet},
                         wall{plane{{0, 0, 0}, {0, 1, 0}}},
                         wall{plane{{0, side, 0}, {0, -1, 0}}},
                         wall{plane{{0, 0, 0}, {0, 0, 1}}, still, none{}, wet},
                         wall{plane{{0, 0, side}, {0, 0, -1}}, still, none{}, wet}};
}

template <class System>
std::size_t bridges_at_walls(const System& s) {
  const auto view = s.view();
  std::size_t found = 0;
  view.for_each_row([&](std::size_t p) { found += view.is_at_wall(p) && s.bridges().is_bonded(p) ? 1 : 0; });
  return found;
}
}  // namespace

TEST_CASE("not a drop is lost at walls under any protocol") {
  const auto check = [](const auto& protocol) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}},
                       glass(protocol), wet_box(5e-3), velocity_verlet{5e-6, {0, 0, -9.81}},
                       run_options{.force = true}};
    for (const grain& g : loose_lattice(4, 4, 4, 0.5e-3, 0.1, 1.2e-3, 0.2)) s.add(g);
    s.run(2000);
    const double all = 1e-2 * 0.125e-9 * 180;
    s.distribute_liquid(all);
    CHECK(bridges_at_walls(s) > 5);
    random_numbers random(7);
    std::size_t most = 0, least = 1000;
    for (int kick = 0; kick < 10; ++kick) {
      for (vector& v : s.particles().template get<column::velocity>()) v += 0.4 * random.in_cube();
      s.run(400);
      CHECK(s.bridges().book().total() == within(1e-12, all));
      most = std::max(most, bridges_at_walls(s));
      least = std::min(least, bridges_at_walls(s));
    }
    CHECK(s.events().ruptures > 50);
    CHECK(most > least);
  };
  check(protocol::neighbours{});
  check(protocol::homogeneous{40});
  check(protocol::grain_films{});
  check(protocol::gravity{});
  check(protocol::none{});
}

TEST_CASE("a grain that is knocked off a wall takes its liquid along and leaves it where it lands") {
  pendular::system s{
      material{normal::linear{1e3}, damping::viscous{0.5}}, glass(protocol::grain_films{}),
      boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}},
                      wall{plane{{0, 0, 2.6e-3}, {0, 0, -1}}, boundary::fixed{}, none{}, boundary::wettable{}}},
      velocity_verlet{2e-6}};
  s.add({.position = {0, 0, radius - 1e-9}, .radius = radius, .density = 2600, .velocity = {0, 0, 0.5}});
  s.distribute_liquid(0.01 * cube);
  s.run(450);  // 0.9 ms, 0.4 mm: off the floor, not yet at the lid
  CHECK(s.bridges().count() == 0);
  CHECK(s.bridges().book().films()[0] == within(1e-14, 0.01 * cube));
  s.run(600);
  CHECK((s.events().ruptures >= 1 && s.events().formations >= 1));
  CHECK(s.bridges().book().total() == within(1e-14, 0.01 * cube));
  CHECK(bridges_at_walls(s) == 1);
}

TEST_CASE("the energy book closes over bridges at walls that move") {
  pendular::system s{
      material{normal::linear{1e3}, damping::viscous{0.2}, friction::coulomb_spring{800, 0.4}, energy_book{}},
      liquid{water, capillary::laplace_young{water}, rupture::laplace_young{water}, protocol::grain_films{}},
      boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}},
                      wall{plane{{0, 0, 2 * radius - 2e-7}, {0, 0, -1}}, boundary::constant_velocity{{0.005, 0, 0.02}},
                           none{}, boundary::wettable{}}},
      velocity_verlet{1e-6}};
  s.add({.position = {0, 0, radius - 1e-7}, .radius = radius, .density = 2600});
  s.distribute_liquid(0.02 * cube);
  REQUIRE(s.bridges().count() == 2);
  const auto before = observe::energies_of(s);
  CHECK(before.capillary < -1e-8);
  double worst = 0;
  for (int k = 0; k < 100; ++k) {
    s.run(300);
    const auto now = observe::energies_of(s);
    worst = std::max(worst, std::abs(now.balance() - before.balance()) / now.turnover_since(before));
  }
  CHECK(s.events().ruptures >= 1);
  CHECK(observe::energies_of(s).walls > 1e-8);
  CHECK(worst < 5e-3);
}

TEST_CASE("a viscous bridge holds a grain back from a wall as from a plane, be the wall rough or smooth") {
  constexpr fluid oil{1e-9, 0, 900, 0.1};
  constexpr double gap = 2e-5, volume = 1e-11, eta = 0.1;
  const auto check = [&](const auto& of_wall) {
    pendular::system s{
        material{normal::linear{1}, friction::coulomb_spring{0.8, 0.0}, energy_book{}},
        liquid{oil, capillary::constant{}, rupture::willett{}, viscous::lubrication{1e-2}},
        boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, of_wall, boundary::wettable{}}},
        velocity_verlet{1e-9}, run_options{.force = true}};
    s.add({.position = {0, 0, radius + gap}, .radius = radius, .density = 2600, .velocity = {0.03, 0, -0.02}});
    s.distribute_liquid(volume);
    const vector force = s.particles().template get<column::force>()[0];
    const double filled = 1 - 1 / std::sqrt(1 + volume / (pi * radius * gap * gap));  // R_h = 2 R, R* = R
    CHECK(force.z == within(1e-3, 6 * pi * eta * radius * radius * 0.02 / gap * filled * filled));
    CHECK(force.x == within(1e-3, -6 * pi * eta * radius * 0.03 * (8.0 / 15 * std::log(radius / gap) + 0.9588)));
    CHECK(s.particles().template get<column::torque>()[0].y == within(1e-12, -(radius + gap) * force.x));
    const auto before = observe::energies_of(s);
    s.run(20000);
    const auto now = observe::energies_of(s);
    CHECK(now.friction > 0.005 * before.kinetic);
    CHECK(std::abs(now.balance() - before.balance()) < 2e-3 * now.turnover_since(before));
  };
  check(none{});
  check(material{normal::linear{1}});
}

TEST_CASE("a bridge at a wall counts in the limits of the scene and in the validity of its laws") {
  auto s = above_floor(0, 1e-2 * cube);
  CHECK(s.bridges().outside().capillary_law == 0);
  CHECK(above_floor(0, 0.4 * cube).bridges().outside().capillary_law == 1);
  pendular::system light{material{normal::linear{1e3}}, glass(), wet_floor(), velocity_verlet{1e-2},
                         run_options{.force = true}};
  light.add({.position = {0, 0, radius}, .radius = radius, .density = 2600});
  light.distribute_liquid(1e-2 * cube);
  int broken = 0;
  for (const auto& limit : light.limits()) {
    if (limit.what.find("capillary") != std::string::npos && !limit.holds()) ++broken;
  }
  CHECK(broken == 1);  // the time step against the slope of the force
}

TEST_CASE("a wettable wall in a dry scene, and a dry wall in a wet one, carry no bridge") {
  pendular::system dry_scene{material{normal::linear{1e3}}, wet_floor(), velocity_verlet{1e-6}};
  dry_scene.add({.position = {0, 0, radius}, .radius = radius, .density = 2600});
  dry_scene.run(1);
  CHECK(dry_scene.particles().get<column::force>()[0] == vector{0, 0, 0});
  pendular::system s{material{normal::linear{1e3}}, glass(), floor_plane(), velocity_verlet{1e-6}};
  s.add({.position = {0, 0, radius}, .radius = radius, .density = 2600});
  s.distribute_liquid(1e-2 * cube);
  CHECK(s.bridges().count() == 0);
  CHECK(s.bridges().book().films()[0] == within(1e-14, 1e-2 * cube));
}

TEST_CASE("only grains near a wall count as touching it in the limit of the time step") {
  const auto limit = [](double height) {
    pendular::system s{material{normal::linear{1e3}}, glass(), wet_floor(), velocity_verlet{1e-6}};
    s.add({.position = {0, 0, height}, .radius = radius, .density = 2600});
    s.add({.position = {0, 0, height + 2 * radius - 1e-7}, .radius = radius, .density = 2600});
    s.distribute_liquid(0.1 * cube);
    return s.limits().front().bound;
  };
  CHECK(limit(1.35 * radius) == limit(9 * radius));  // within reach of a bridge, but not of a touch
  CHECK(limit(1.05 * radius) < 0.8 * limit(9 * radius));
}

TEST_CASE("a bridge between grains that leave a wall together forms at the same step for every skin") {
  // Their films hold twice what the largest bridge held when the list was made.
  const auto formed_at = [](double skin) {
    pendular::system s{material{normal::linear{1e3}},
                       liquid{fluid::water(), capillary::constant{}, rupture::willett{}, protocol::neighbours{},
                              formation::within_rupture_distance{}},
                       wet_floor(), velocity_verlet{1e-7}, run_options{.skin = skin, .force = true}};
    s.add({.position = {0, 0, radius}, .radius = radius, .density = 2600});
    s.add({.position = {2.24 * radius, 0, radius}, .radius = radius, .density = 2600});
    s.distribute_liquid(0.02 * cube);
    REQUIRE(s.bridges().count() == 2);
    for (vector& v : s.particles().template get<column::velocity>()) v = {0, 0, 1};
    while (s.events().formations == 0 && s.step_count() < 4000) s.run(1);
    return s.step_count();
  };
  const std::int64_t usual = formed_at(0.2);
  CHECK((usual > 1500 && usual < 4000));
  CHECK(formed_at(0.01) == usual);
  CHECK(formed_at(1) == usual);
}

namespace {
/// For a grain that is pressed a little by both walls.
auto between_wet_walls() {
  return pendular::system{
      material{normal::linear{1e3}, damping::viscous{0.3}}, glass(protocol::neighbours{}),
      boundary::walls{
          wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}},
          wall{plane{{0, 0, 2 * radius - 1e-7}, {0, 0, -1}}, boundary::fixed{}, none{}, boundary::wettable{}}},
      velocity_verlet{1e-6}, run_options{.force = true}};
}
}  // namespace

TEST_CASE("a wall that jumps away leaves its liquid to the grain, in a run that goes on and in one that is resumed") {
  auto s = between_wet_walls();
  s.add({.position = {0, 0, radius - 5e-8}, .radius = radius, .density = 2600});
  s.distribute_liquid(0.02 * cube);
  s.run(10);
  REQUIRE(s.bridges().count() == 2);
  boundary::get<1>(s.walls()).shape.point.z = 6 * radius;
  auto fresh = resumed(s, between_wet_walls());
  for (auto* each : {&s, &fresh}) {
    each->run(100);
    CHECK(each->bridges().count() == 1);
    CHECK(each->bridges().book().films()[0] == 0);
    CHECK(each->bridges().book().bonds()[each->view().first.size()] == within(1e-13, 0.02 * cube));
  }
  CHECK(s.particles().get<column::position>()[0] == fresh.particles().get<column::position>()[0]);
}

TEST_CASE("a film that reaches a grain which has long touched a wet wall makes no bridge there, resumed or not") {
  auto s = between_wet_walls();
  s.add({.position = {0, 0, radius - 5e-8}, .radius = radius, .density = 2600});
  s.run(10);
  auto fresh = resumed(s, between_wet_walls());
  for (auto* each : {&s, &fresh}) {
    each->exchange("spray", [](auto& door) { door.wet_grain(0, 0.01 * cube); });
    each->run(10);
    CHECK(each->bridges().count() == 0);
    CHECK(each->bridges().book().films()[0] == within(1e-13, 0.01 * cube));
  }
}
