// SPDX-License-Identifier: BSD-3-Clause
// Sources and sinks against the differential equations that their rates are, solved by hand, and what the door does and
// refuses.
#include "hand_made.hpp"

#include "../catch.hpp"

#include <pendular/liquid/door.hpp>
#include <pendular/liquid/source/all.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

using namespace pendular;
using namespace hand_made;

namespace {

constexpr double pi = std::numbers::pi;

/// Two touching grains of radius 1 and one of radius 2 apart.
packing touching_pair() {
  packing p;
  p.position = {{0, 0, 0}, {2, 0, 0}, {0, 50, 0}};
  p.radius = {1, 1, 2};
  p.pairs = {{0, 1}, {1, 2}};
  return p.listed();
}

/// `times` periods of a source over `span` each.
template <class Liquid, class S>
void act(bonds<Liquid>& b, const packing& p, const S& source, double span, int times = 1) {
  const pair_view v = p.view();
  const auto pairs_of = [&](std::size_t grain) -> const auto& { return p.of_grain[grain]; };
  for (int k = 0; k < times; ++k) {
    outside_door door(b, v, pairs_of, source.account, span);
    source.act(door);
    door.close();
  }
}

/// Meniscus of a bridge between two touching spheres of radius 1 at contact angle 0 as a torus that touches both at the
/// half-filling angle: volume and surface by Pappus (the toroidal approximation of Haines and Fisher).
struct torus {
  double volume, surface;
};
torus at_filling_angle(double angle) {
  const double arc_radius = 1 / std::cos(angle) - 1, ring = std::tan(angle);  // of the meridian's arc; of its centre
  const double half = pi / 2 - angle;                                         // of the arc
  const double surface = 2 * pi * arc_radius * (ring * 2 * half - arc_radius * 2 * std::sin(half));
  // The disc of radius x(z) up to the height of the three-phase line, less the two caps of the spheres.
  const int slices = 20000;
  const double top = 1 - std::cos(angle);
  double volume = 0;
  for (int k = 0; k < slices; ++k) {
    const double z = top * (k + 0.5) / slices, x = ring - std::sqrt(arc_radius * arc_radius - z * z);
    volume += 2 * pi * x * x * top / slices;
  }
  return {volume - 2 * pi / 3 * top * top * (2 + std::cos(angle)), surface};
}

}  // namespace

TEST_CASE(
    "the surface of a meniscus is that of a torus where the bridge is small, and of a cylinder where it is straight") {
  for (const double angle : {0.05, 0.1, 0.2, 0.3}) {
    const torus t = at_filling_angle(angle);
    const double ours = source::meniscus_surface({0, t.volume, 1, 1}, fluid::water());
    CHECK(ours == within(0.25 * angle, t.surface));
  }
  // A gap makes the bridge taller and thinner: a cylinder of this radius and height if the volume is fixed.
  fluid wax = fluid::water();
  wax.contact_angle = pi / 2 - 1e-9;  // a straight meniscus
  const double volume = pi * 0.1 * 0.1 * 2 + pi / 2 * std::pow(0.1, 4);
  CHECK(source::meniscus_surface({2, volume, 1, 1}, wax) == within(1e-6, 2 * pi * 0.1 * 2.01));
  // A wall is flat: the space is half as thick at the same radius.
  const double at_wall = pi / 4 * std::pow(0.1, 4);
  CHECK(source::meniscus_surface({0, at_wall, 1, wall_radius(1.0)}, wax) == within(1e-6, 2 * pi * 0.1 * 0.005));
  CHECK(source::meniscus_surface({-0.3, at_wall, 1, 1}, wax) == source::meniscus_surface({0, at_wall, 1, 1}, wax));
}

TEST_CASE("films dry at their rate in proportion to the surface of the grain, and not beyond dryness") {
  const packing p = touching_pair();
  auto b = bonds_of(wet(rupture::lian{}), p, {}, {1e-2, 1e-4, 1e-2});
  act(b, p, source::evaporation{.film_rate = 1e-6, .bridge_rate = 1}, 10, 20);
  const double of_unit_radius = 1e-6 * 4 * pi * 200;
  CHECK(b.book().films()[0] == within(1e-12, 1e-2 - of_unit_radius));
  CHECK(b.book().films()[1] == 0);
  CHECK(b.book().films()[2] == within(1e-12, std::max(0.0, 1e-2 - 4 * of_unit_radius)));
  CHECK(b.book().outside("vapour") + b.book().total() == within(1e-14, b.book().introduced()));
}

TEST_CASE("a bridge dries as V^(1/4) falls linearly in time, dV/dt = - rate times the surface") {
  const packing p = touching_pair();
  const double volume = 1e-3, rate = 1e-3, time = 5;
  auto b = bonds_of(wet(rupture::lian{}), p, {volume}, {});
  act(b, p, source::evaporation{.film_rate = 1, .bridge_rate = rate}, time / 5000, 5000);
  // Surface at contact, theta = 0, R = 1: pi^2 (2 V / pi)^(3/4), hence d V^(1/4) / dt = - rate pi^2 (2 / pi)^(3/4) / 4
  const double root = std::pow(volume, 0.25) - rate * pi * pi * std::pow(2 / pi, 0.75) / 4 * time;
  CHECK(b.book().bonds()[0] == within(1e-3, std::pow(root, 4)));
  CHECK(b.book().outside("vapour") == within(1e-12, volume - b.book().bonds()[0]));
}

TEST_CASE("films dry where bridges do not, and bridges where films do not") {
  const packing p = touching_pair();
  const auto dried = [&](const source::evaporation& rates) {
    auto b = bonds_of(wet(rupture::lian{}), p, {0.01}, {0.5, 0.5, 0.5});
    act(b, p, rates, 1);
    return std::pair{b.book().films()[0], b.book().bonds()[0]};
  };
  CHECK(dried({.film_rate = 1e-3, .bridge_rate = 0}) == std::pair{0.5 - 1e-3 * 4 * pi, 0.01});
  const auto [film, bridge] = dried({.film_rate = 0, .bridge_rate = 1e-3});
  CHECK((film == 0.5 && bridge < 0.01));
}

TEST_CASE("a bridge that dries below the minimum volume breaks and leaves its rest to the grains") {
  const packing p = touching_pair();
  auto b = bonds_of(wet(rupture::lian{}, formation::at_contact{.minimum_volume = 1e-3}), p, {1.001e-3}, {});
  act(b, p, source::evaporation{.film_rate = 0, .bridge_rate = 1e-3}, 1);
  CHECK(b.count() == 0);
  CHECK(b.events().ruptures == 1);
  CHECK(b.book().films()[0] == b.book().films()[1]);
  CHECK(b.book().films()[0] > 0);
  CHECK(b.book().total() + b.book().outside("vapour") == within(1e-14, 1.001e-3));
}

TEST_CASE("wetting gives every chosen grain its volume, and a dry contact learns of it") {
  const packing p = touching_pair();
  auto b =
      bonds_of(wet(volume_is_distance{}, protocol::grain_films{}, formation::within_rupture_distance{}), p, {}, {});
  const auto small = [](const source::wettable_grain& g) { return g.radius < 1.5; };
  act(b, p, source::wetting{0.2, 10, small}, 1, 3);
  CHECK((b.book().films()[0] == within(1e-14, 0.6) && b.book().films()[1] == within(1e-14, 0.6)));
  CHECK(b.book().films()[2] == 0);
  CHECK(b.forms_below(0) == within(1e-14, 1.2));
  CHECK(b.book().outside("spray") == within(1e-14, -1.2));
  act(b, p, source::wetting{0.5}, 1);
  CHECK(b.book().films()[2] == 0.5);
  CHECK(b.book().here() == within(1e-14, b.book().total()));
}

TEST_CASE("the door moves liquid between films and bridges and keeps what a bridge must be") {
  const packing p = touching_pair();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}), p, {0.1}, {0.5, 0, 1});
  const pair_view v = p.view();
  const auto pairs_of = [&](std::size_t grain) -> const auto& { return p.of_grain[grain]; };
  liquid_door door(b, v, pairs_of);
  CHECK((door.grains() == 3 && door.radius(2) == 2 && door.film(0) == 0.5 && door.is_bridged(0)));
  CHECK((door.bridge_at(0).volume == 0.1 && door.bridge_at(0).gap == 0));
  door.from_film_to_film(0, 1, 0.2);
  CHECK(door.from_film_to_bridge(1, 0, 0.15));
  door.from_bridge_to_film(0, 2, 0.05);
  CHECK(b.book().films()[0] == within(1e-14, 0.3));
  CHECK(b.book().films()[1] == within(1e-14, 0.05));
  CHECK(b.book().films()[2] == within(1e-14, 1.05));
  CHECK(b.breaks_above(0) == within(1e-14, 0.2));
  CHECK_FALSE(door.from_film_to_bridge(2, 1, 0.5));  // its pair is 46 m apart
  CHECK(b.book().films()[2] == within(1e-14, 1.05));
  door.break_bridge(0);
  door.close();
  CHECK((b.count() == 0 && b.book().films()[0] == within(1e-14, 0.4) && b.book().films()[1] == within(1e-14, 0.15)));
  CHECK(b.book().total() == within(1e-14, 1.6));
}

TEST_CASE("what the door moves onto a film is known to the dry pairs of its grain") {
  const packing p = touching_pair();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}, formation::within_rupture_distance{}), p, {0.1},
                    {0.5, 0, 0});
  const pair_view v = p.view();
  const auto pairs_of = [&](std::size_t grain) -> const auto& { return p.of_grain[grain]; };
  liquid_door door(b, v, pairs_of);
  door.from_film_to_film(0, 2, 0.2);
  door.close();
  CHECK(b.forms_below(1) == within(1e-14, 0.2));
  door.break_bridge(0);
  door.close();
  CHECK(b.forms_below(1) == within(1e-14, 0.25));
  CHECK(b.forms_below(0) == within(1e-14, 0.4));
}

TEST_CASE("the door makes no bridge of less than the minimum volume, and counts one that its laws are not valid for") {
  const packing p = touching_pair();
  auto b = bonds_of(wet(rupture::lian{}, formation::at_contact{.minimum_volume = 1e-3}), p, {}, {0.5, 0, 0});
  const pair_view v = p.view();
  const auto pairs_of = [&](std::size_t grain) -> const auto& { return p.of_grain[grain]; };
  liquid_door door(b, v, pairs_of);
  CHECK_FALSE(door.from_film_to_bridge(0, 0, 0.9e-3));
  CHECK((b.count() == 0 && b.book().films()[0] == 0.5));
  CHECK(door.from_film_to_bridge(0, 0, 0.4));  // valid up to 0.1 R^3
  door.close();
  CHECK(b.outside().rupture_law == 1);
}

TEST_CASE("the door refuses what is not there and what is no volume, in a sentence") {
  const packing p = touching_pair();
  auto b = bonds_of(wet(volume_is_distance{}), p, {0.1}, {0.5, 0, 1});
  const pair_view v = p.view();
  const auto pairs_of = [&](std::size_t grain) -> const auto& { return p.of_grain[grain]; };
  outside_door door(b, v, pairs_of, "pump", 1.0);
  const auto message = [](const auto& attempt) {
    try {
      attempt();
    } catch (const input_error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(message([&] { door.dry_grain(0, 0.6); }) ==
        "the volume taken from the film of grain 0 (m3) is 0.6, but must be at least 0 and at most the 0.5 that are "
        "there (see docs/reference/liquid.md)");
  CHECK(message([&] { door.drain_bridge(0, 0.2); }) ==
        "the volume taken from the bridge of 0 and 1 (m3) is 0.2, but must be at least 0 and at most the 0.1 that are "
        "there (see docs/reference/liquid.md)");
  CHECK(message([&] { door.wet_grain(0, -1); }) ==
        "the volume that a source gives (m3) is -1, but must be at least 0 and finite (see docs/reference/liquid.md)");
  CHECK_FALSE(message([&] { door.fill_bridge(0, HUGE_VAL); }).empty());
  CHECK_FALSE(message([&] { door.from_film_to_film(2, 0, std::nan("")); }).empty());
  CHECK(message([&] { door.wet_grain(3, 0.1); }) ==
        "the row of a grain at a door is 3, but must be one that the door visits (see docs/reference/liquid.md)");
  CHECK_FALSE(message([&] { door.dry_grain(3, 0.1); }).empty());
  CHECK_FALSE(message([&] { door.from_film_to_film(0, 3, 0.1); }).empty());
  CHECK_FALSE(message([&] { door.from_film_to_bridge(0, 99, 0.1); }).empty());
  CHECK_FALSE(message([&] { door.from_bridge_to_film(99, 0, 0.1); }).empty());
  CHECK_FALSE(message([&] { door.fill_bridge(99, 0.1); }).empty());
  REQUIRE(v.is_padding(2));
  CHECK_FALSE(message([&] { door.fill_bridge(2, 0.1); }).empty());
  CHECK_FALSE(message([&] { door.drain_bridge(99, 0.0); }).empty());
  CHECK_FALSE(message([&] { door.break_bridge(99); }).empty());
  CHECK(b.book().total() == within(1e-15, 1.6));
}

TEST_CASE("sources without meaning are refused where the liquid is built") {
  const auto with = [](const auto& s) { return wet(rupture::lian{}, s); };
  CHECK_NOTHROW(with(source::evaporation{0, 0}));
  CHECK_THROWS_AS(with(source::evaporation{-1, 0}), input_error);
  CHECK_THROWS_AS(with(source::evaporation{0, std::nan("")}), input_error);
  CHECK_THROWS_AS(with(source::evaporation{0, 0, 0}), input_error);
  CHECK_THROWS_AS(with(source::wetting{-1e-12}), input_error);
  CHECK_THROWS_AS(with(source::wetting{1e-12, -5}), input_error);
}
