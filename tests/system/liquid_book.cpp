// SPDX-License-Identifier: BSD-3-Clause

// Not a drop is lost: all protocols in shaken packings with hundreds of ruptures and formations (physics 4.7 K), and the
// rules by which each protocol moves what a broken bridge sets free (physics, protocol numbering).
#include "../physics/scenes.hpp"

#include <algorithm>

using namespace pendular;
using namespace scenes;

namespace {

constexpr double cube = 0.5e-3 * 0.5e-3 * 0.5e-3;  // R^3, m3

template <class Protocol>
auto water_with(const Protocol& p) {
  return liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, p};
}

template <class Protocol>
auto shaken_box(const Protocol& protocol) {
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}},
                     water_with(protocol), closed_box({6e-3, 6e-3, 6e-3}), velocity_verlet{5e-6, {0, 0, -9.81}},
                     run_options{.force = true}};
  for (const grain& g : loose_lattice(5, 5, 5, 0.5e-3, 0.1, 1.2e-3, 0.2)) s.add(g);
  s.run(2000);
  s.distribute_liquid(1e-2 * cube * 350);
  return s;
}

/// Every 500 steps all grains get a new velocity; the largest relative loss of liquid meanwhile.
template <class System>
double worst_loss(System& s, int kicks) {
  random_numbers random(99);
  const double all = s.bridges().book().introduced();
  double worst = 0;
  for (int kick = 0; kick < kicks; ++kick) {
    for (vector& v : s.particles().template get<column::velocity>()) v += 0.4 * random.in_cube();
    for (int part = 0; part < 10; ++part) {
      s.run(50);
      const auto& book = s.bridges().book();
      worst = std::max(worst, std::abs(book.total() / all - 1));
      double plain = book.balance(ledger::reservoir());
      for (const double v : book.films()) plain += v;
      for (const double v : book.bonds()) plain += v;
      worst = std::max(worst, std::abs(plain / all - 1));
      CHECK(*std::min_element(book.films().begin(), book.films().end()) >= 0);
      CHECK(*std::min_element(book.bonds().begin(), book.bonds().end()) >= 0);
    }
  }
  return worst;
}

/// Volume of the bridge of two grains, 0 without one.
template <class System>
double bridge_between(const System& s, std::int64_t i, std::int64_t j) {
  const auto view = s.view();
  for (std::size_t p = 0; p < view.pairs; ++p) {
    if (view.id[view.grain_i(p)] == std::min(i, j) && view.id[view.grain_j(p)] == std::max(i, j)) {
      return s.bridges().book().bonds()[p];
    }
  }
  return 0;
}

template <class System>
double film_on(const System& s, std::int64_t id) {
  return s.bridges().book().films()[row_of(s, id)];
}

}  // namespace

TEST_CASE("liquid is conserved through hundreds of ruptures and formations under every protocol") {
  const auto check = [](const auto& protocol, bool forms_again) {
    auto s = shaken_box(protocol);
    CHECK(worst_loss(s, 12) <= 1e-12);
    CHECK(s.events().ruptures > 100);
    if (forms_again) CHECK(s.events().formations > 100 + 300);
    CAPTURE(s.events().ruptures, s.events().formations);
  };
  check(protocol::neighbours{}, false);
  check(protocol::homogeneous{40}, true);
  check(protocol::grain_films{}, true);
  check(protocol::gravity{}, false);
  check(protocol::none{}, false);
}

TEST_CASE("homogeneous redistribution gives every bridge the same volume over R^3") {
  auto s = shaken_box(protocol::homogeneous{25});
  worst_loss(s, 2);
  REQUIRE(s.bridges().count() > 100);
  const auto view = s.view();
  double low = 1, high = 0;
  for (std::size_t p = 0; p < view.pairs; ++p) {
    if (!s.bridges().is_bonded(p)) continue;
    const double size = std::pow(view.radius[view.grain_i(p)] * view.radius[view.grain_j(p)], 1.5);
    low = std::min(low, s.bridges().book().bonds()[p] / size);
    high = std::max(high, s.bridges().book().bonds()[p] / size);
    CHECK(view.gap(p) <=
          s.bridges().policies().rupture_distance(view.bridge_of(p, 0, s.bridges().book().bonds()[p])) * 1.001);
  }
  CHECK(high / low - 1 < 1e-14);
  double bonded = 0;
  for (const double v : s.bridges().book().bonds()) bonded += v;
  CHECK(bonded == within(1e-12, s.bridges().book().introduced()));
}

namespace {
/// A chain along x, small and large grains touching, 1 um of overlap; V_b = 0.01 R^3 at every contact. Then the pair of
/// grains 1 and 2 is pulled apart beyond rupture.
template <class Protocol>
auto broken_chain(const Protocol& protocol) {
  pendular::system s{material{normal::linear{1e3}}, water_with(protocol), boundary::walls{},
                     velocity_verlet{1e-12, {0, 0, -1e-9}}, run_options{.force = true}};
  // 0 - 1 | 2 - 3, with radii 0.5, 0.5 | 1, 0.75 mm, and 4 (0.25 mm) below 2, 5 (0.5 mm) above 2
  const double d = 1e-9;
  // and 0 a little above 1
  s.add({vector{1.0e-3 - d, 0, 0} + (1.0e-3 - d) * vector{-0.8, 0, 0.6}, 0.5e-3, 2600});
  s.add({{1.0e-3 - d, 0, 0}, 0.5e-3, 2600});
  s.add({{2.5e-3 - 2 * d, 0, 0}, 1e-3, 2600});
  s.add({{4.25e-3 - 3 * d, 0, 0}, 0.75e-3, 2600});
  s.add({{2.5e-3 - 2 * d, 0, -1.25e-3 + d}, 0.25e-3, 2600});
  s.add({{2.5e-3 - 2 * d, 0, 1.5e-3 - d}, 0.5e-3, 2600});
  s.start();
  s.distribute_liquid(1e-12);
  return s;
}
/// Grains 0 and 1 together to a new place along x, in moves that the neighbour list can follow.
template <class System>
void carry_0_and_1(System& s, double way) {
  for (int part = 0; part < 20; ++part) {
    for (const std::int64_t id : {0, 1}) position(s, id).x += way / 20;
    for (vector& v : s.particles().template get<column::velocity>()) v = {0, 0, 0};
    s.run(1);
  }
}
template <class System>
void pull_apart(System& s) {
  carry_0_and_1(s, -0.4e-3);
}
}  // namespace

TEST_CASE("a broken bridge is split in proportion to the diameters and each protocol moves the parts by its rule") {
  SECTION("none and films: it stays on the two grains") {
    const auto check = [](auto s) {
      const double broken = bridge_between(s, 1, 2);
      REQUIRE(broken > 0);
      pull_apart(s);
      CHECK(s.events().ruptures == 1);
      CHECK(film_on(s, 1) == within(1e-12, broken / 3));  // D = 1 and 2 mm
      CHECK(film_on(s, 2) == within(1e-12, broken * 2 / 3));
    };
    check(broken_chain(protocol::none{}));
    check(broken_chain(protocol::grain_films{}));
  }
  SECTION("neighbours: to the other bridges of the same grain in proportion to the partners' diameters") {
    auto s = broken_chain(protocol::neighbours{});
    const double broken = bridge_between(s, 1, 2), to_0 = bridge_between(s, 0, 1), to_3 = bridge_between(s, 2, 3),
                 to_4 = bridge_between(s, 2, 4), to_5 = bridge_between(s, 2, 5);
    pull_apart(s);
    CHECK(bridge_between(s, 0, 1) == within(1e-12, to_0 + broken / 3));
    // Partners of grain 2: 0.75, 0.25, 0.5 mm
    CHECK(bridge_between(s, 2, 3) == within(1e-12, to_3 + broken * 2 / 3 * 0.75 / 1.5));
    CHECK(bridge_between(s, 2, 4) == within(1e-12, to_4 + broken * 2 / 3 * 0.25 / 1.5));
    CHECK(bridge_between(s, 2, 5) == within(1e-12, to_5 + broken * 2 / 3 * 0.5 / 1.5));
    CHECK(film_on(s, 1) == near(1e-27, 0));
    CHECK(film_on(s, 2) == near(1e-27, 0));
  }
  SECTION("gravity: to the lowest bridge of the lower hemisphere, and where there is none it stays") {
    auto s = broken_chain(protocol::gravity{});
    const double broken = bridge_between(s, 1, 2), to_3 = bridge_between(s, 2, 3), to_4 = bridge_between(s, 2, 4),
                 to_5 = bridge_between(s, 2, 5);
    pull_apart(s);
    CHECK(bridge_between(s, 2, 4) == within(1e-12, to_4 + broken * 2 / 3));
    CHECK(bridge_between(s, 2, 3) == to_3);
    CHECK(bridge_between(s, 2, 5) == to_5);
    CHECK(film_on(s, 1) == within(1e-12, broken / 3));  // its only other bridge is above
  }
  SECTION("films: a grain's film goes in equal parts to all contacts that form in one step") {
    auto s = broken_chain(protocol::grain_films{});
    const double broken = bridge_between(s, 1, 2);
    pull_apart(s);
    // Grain 1 comes back and touches 2 again and nothing else.
    carry_0_and_1(s, 0.4e-3);
    CHECK(bridge_between(s, 1, 2) == within(1e-12, broken));
    CHECK(film_on(s, 1) + film_on(s, 2) == near(1e-27, 0));
  }
}
