// SPDX-License-Identifier: BSD-3-Clause
// Which pairs a homogeneous distribution wets, and the films that the roughness of the grains keeps from bridges.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <pendular/boundary/plane.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <limits>

using namespace pendular;
using namespace hand_made;

namespace {
constexpr double everything = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979324;

/// A row of grains of radii 1 and 2, 1 and 2: gaps of -0.01, 0.05 and 0.2.
packing row() {
  packing c;
  c.radius = {1, 2, 1, 2};
  c.position = {{0, 0, 0}, {2.99, 0, 0}, {6.04, 0, 0}, {9.24, 0, 0}};
  c.pairs = {{0, 1}, {1, 2}, {2, 3}};
  return c.listed();
}

template <class Protocol>
auto distributed(const Protocol& p, double volume, const bond_selection& selection) {
  const packing c = row();
  auto b = bonds_of(wet(rupture::lian{}, p), c, {}, {});
  b.introduce(volume);
  distribute(b, c.view(), selection);
  CHECK(b.book().total() == within(1e-15, volume));
  return b;
}

std::vector<bool> bonded(const auto& b) { return {b.is_bonded(0), b.is_bonded(1), b.is_bonded(2)}; }
}  // namespace

TEST_CASE("a distribution wets touching pairs only, or those within a gap, or all that are eligible") {
  const auto bridges = [](double widest_gap) {
    return bonded(distributed(protocol::homogeneous{}, 0.06, {.widest_gap = widest_gap}));
  };
  CHECK(bridges(0) == std::vector{true, false, false});
  CHECK(bridges(0.049) == std::vector{true, false, false});
  CHECK(bridges(0.051) == std::vector{true, true, false});
  CHECK(bridges(0.19) == std::vector{true, true, false});
  CHECK(bridges(0.21) == std::vector{true, true, true});
  CHECK(bridges(everything) == std::vector{true, true, true});
}

TEST_CASE("the pairs that are wetted share all of the liquid") {
  const auto touching = distributed(protocol::homogeneous{}, 0.06, {.widest_gap = 0});
  CHECK(touching.book().bonds()[0] == within(1e-14, 0.06));
  const auto two = distributed(protocol::homogeneous{}, 0.06, {.widest_gap = 0.1});
  CHECK((two.book().bonds()[0] == within(1e-14, 0.03) && two.book().bonds()[1] == within(1e-14, 0.03)));
}

TEST_CASE("a gap that is allowed but not eligible stays dry") {
  // 0.002 in three bridges is 0.00067 each, which reaches 0.087; in two 0.1
  CHECK(bonded(distributed(protocol::homogeneous{}, 0.002, {.widest_gap = 1})) == std::vector{true, true, false});
}

TEST_CASE("thinning and gap are asked both") {
  int wetted = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto b = distributed(protocol::homogeneous{}, 0.06, {.thinning = 2, .seed = seed, .widest_gap = 0});
    CHECK_FALSE(b.is_bonded(1));
    wetted += b.is_bonded(0) ? 1 : 0;
  }
  CHECK((wetted > 70 && wetted < 130));
}

TEST_CASE("grains keep a film of their surface times its thickness, and bridges get the rest") {
  // surfaces of 4 pi (1 + 4 + 1 + 4)
  const double held = 4e-4 * pi * 10;
  const auto b = distributed(protocol::homogeneous{}, 0.06, {.film_thickness = 1e-4});
  CHECK(b.book().films()[0] == within(1e-14, 4e-4 * pi));
  CHECK(b.book().films()[1] == within(1e-14, 16e-4 * pi));
  for (std::size_t p = 0; p < 3; ++p) CHECK(b.book().bonds()[p] == within(1e-13, (0.06 - held) / 3));
  for (std::size_t grain = 0; grain < 4; ++grain) CHECK(b.free_film(grain, row().view()) == 0);
}

TEST_CASE("without enough for all films there is no bridge, and films go with the surface") {
  const auto b = distributed(protocol::homogeneous{}, 0.01, {.film_thickness = 1e-4});
  CHECK(b.count() == 0);
  for (std::size_t grain = 0; grain < 4; ++grain) {
    CHECK(b.book().films()[grain] == within(1e-14, grain % 2 == 0 ? 0.001 : 0.004));
  }
}

TEST_CASE("bridges begin at the liquid that fills the roughness, whatever is in it") {
  const double held = 4e-4 * pi * 10;
  CHECK(distributed(protocol::homogeneous{}, held * 0.999, {.film_thickness = 1e-4}).count() == 0);
  CHECK(distributed(protocol::homogeneous{}, held * 1.001, {.film_thickness = 1e-4}).count() == 1);
}

TEMPLATE_TEST_CASE("no protocol makes a bridge of a film that is held", "", protocol::neighbours, protocol::grain_films,
                   protocol::gravity) {
  packing c;
  c.radius = {1, 1};
  c.position = {{0, 0, 0}, {1.2, 0, -1.6}};  // apart or not is what the gaps say; 1 is below 0
  c.pairs = {{0, 1}};
  c.listed();
  const double held = 4 * pi * 1e-3;
  auto b = bonds_of(wet(volume_is_distance{}, TestType{}), c, {}, {held + 0.02, held * 0.9});
  b.select({.film_thickness = 1e-3});
  b.refresh(0, c.view());
  CHECK(c.settle(b, {-1e-3}).formations == 1);
  CHECK(b.book().bonds()[0] == within(1e-12, 0.02));
  CHECK(b.book().films()[0] == within(1e-12, held));
  CHECK(b.book().films()[1] == held * 0.9);
  // what breaks fills the films first
  CHECK(c.settle(b, {0.5}).ruptures == 1);
  CHECK(b.book().films()[1] == within(1e-12, held * 0.9 + 0.01));
  CHECK(b.free_film(1, c.view()) == within(1e-12, 0.01 - held * 0.1));
}

TEST_CASE("what round-off leaves above a held film is nothing") {
  packing c;
  c.radius = {1};
  c.position = {{0, 0, 0}};
  c.listed();
  const double held = 4 * pi * 1e-3;
  for (const double ulps : {1.0, 3.0}) {
    auto b = bonds_of(wet(volume_is_distance{}), c, {}, {held * (1 + ulps * std::numeric_limits<double>::epsilon())});
    b.select({.film_thickness = 1e-3});
    CHECK(b.free_film(0, c.view()) == 0);
  }
  auto b = bonds_of(wet(volume_is_distance{}), c, {}, {held * (1 + 1e-12)});
  b.select({.film_thickness = 1e-3});
  CHECK(b.free_film(0, c.view()) == within(1e-3, 1e-12 * held));
}

TEMPLATE_TEST_CASE("no protocol makes a bridge to a wall of a film that is held", "", protocol::neighbours,
                   protocol::grain_films, protocol::gravity) {
  packing c;
  c.radius = {1};
  c.position = {{0, 0, 1}};
  c.listed();
  c.floor = {{0, 0, 0.0, {0, 0, -1}}};
  constexpr std::size_t floor = 0;
  const double held = 4 * pi * 1e-3;
  auto b = bonds_of(wet(volume_is_distance{}, TestType{}), c, {}, {held + 0.02});
  b.select({.film_thickness = 1e-3});
  b.refresh(0, c.view());
  const auto step = [&](double gap) { return c.settle(b, std::vector<double>(lane_count, gap)); };
  CHECK(step(-1e-3).formations == 1);
  CHECK(b.book().bonds()[floor] == within(1e-12, 0.02));
  CHECK(b.book().films()[0] == within(1e-12, held));
  CHECK(step(0.5).ruptures == 1);
  CHECK(b.free_film(0, c.view()) == within(1e-12, 0.02));
  CHECK(b.book().total() == within(1e-15, held + 0.02));
}

TEST_CASE("at a wall that carries bridges the gap is asked, too") {
  packing c;
  c.radius = {1, 1};
  c.position = {{0, 0, 1}, {9, 0, 1.3}};
  c.listed();
  c.floor = {{0, 0, 0.0, {0, 0, -1}}, {1, 0, 0.3, {0, 0, -1}}};
  const auto wetted = [&](double widest_gap) {
    auto b = bonds_of(wet(rupture::lian{}, protocol::homogeneous{}), c, {}, {});
    b.introduce(0.2);
    distribute(b, c.view(), {.widest_gap = widest_gap});
    return b.count();
  };
  CHECK((wetted(0) == 1 && wetted(0.29) == 1 && wetted(0.31) == 2));
}

TEST_CASE("touching pairs only stay the same whatever the skin of the neighbour list") {
  for (const double skin : {0.05, 0.2, 0.5}) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.8}},
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::homogeneous{10}},
                       boundary::walls{}, half_step_velocity_verlet{1e-7}, run_options{.skin = skin}};
    s.add({{0, 0, 0}, 1e-3, 2600});
    s.add({{2e-3 - 1e-9, 0, 0}, 1e-3, 2600});
    s.add({{4.1e-3, 0, 0}, 1e-3, 2600});
    s.distribute_liquid(1e-10, {.widest_gap = 0});
    CHECK(s.bridges().count() == 1);
    CHECK(s.selection().widest_gap == 0);
    s.run(20);  // through two distributions of the protocol
    CHECK(s.bridges().count() == 1);
    CHECK(s.bridges().book().total() == within(1e-15, 1e-10));
  }
}

TEST_CASE("gaps and films without meaning are refused, and nothing has changed") {
  pendular::system s{material{normal::linear{1e3}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                     boundary::walls{}, half_step_velocity_verlet{1e-7}};
  for (int k = 0; k < 2; ++k) s.add({{1e-3 * k, 0, 0}, 0.5e-3, 2600});
  for (const double bad : {-1e-9, std::nan("")}) {
    CHECK_THROWS_AS(s.distribute_liquid(1e-12, {.widest_gap = bad}), input_error);
    CHECK_THROWS_AS(s.distribute_liquid(1e-12, {.film_thickness = bad}), input_error);
  }
  for (const double bad : {everything, 1.7e308, 1.0}) {
    CHECK_THROWS_AS(s.distribute_liquid(1e-12, {.film_thickness = bad}), input_error);
  }
  CHECK(s.bridges().book().introduced() == 0);
}
