// SPDX-License-Identifier: BSD-3-Clause
// Many ruptures and formations in one step.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <cmath>
#include <map>
#include <numeric>

using namespace pendular;
using namespace hand_made;

namespace {
/// A bridge that reaches the farther, the larger its grains are.
struct tenth_of_the_radius {
  template <Scalar T>
  T distance(const bridge<T>& b, const fluid&) const {
    return T(0.1) * b.radius_i;
  }
};

struct scene {
  packing grains;
  std::vector<double> volume, film, before, gap;
};

/// 40 grains, 150 pairs of them: bridges that hold, bridges that break, pairs that close dry, that are closed, that are open.
scene of_many_events(std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  scene s;
  for (int k = 0; k < 40; ++k) {
    s.grains.radius.push_back(0.5 + unit(random));
    s.grains.position.push_back({10 * unit(random), 10 * unit(random), 10 * unit(random)});
    s.film.push_back(unit(random) < 0.5 ? 0.0 : 1e-3 * unit(random));
  }
  std::map<std::pair<int, int>, bool> used;
  while (s.grains.pairs.size() < 150) {
    boost::random::uniform_int_distribution<int> any(0, 39);
    const int i = any(random), j = any(random);
    if (i >= j || used[{i, j}]) continue;
    used[{i, j}] = true;
    s.grains.pairs.push_back({i, j});
    s.volume.push_back(unit(random) < 0.7 ? 1e-2 * unit(random) : 0.0);
    s.gap.push_back(unit(random) < 0.5 ? -0.01 : 0.02 * unit(random));
    s.before.push_back(unit(random) < 0.3 ? -0.01 : 0.02 * unit(random));
  }
  s.grains.listed();
  return s;
}

scene shuffled(const scene& s, std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  std::vector<std::size_t> order(s.gap.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = order.size(); k > 1; --k) {
    std::swap(order[k - 1], order[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(random)]);
  }
  scene mixed = s;
  for (std::size_t k = 0; k < order.size(); ++k) {
    mixed.grains.pairs[k] = s.grains.pairs[order[k]];
    mixed.volume[k] = s.volume[order[k]];
    mixed.gap[k] = s.gap[order[k]];
    mixed.before[k] = s.before[order[k]];
  }
  mixed.grains.listed();
  return mixed;
}

/// Volume of every bridge and film after two steps, by grains and not by rows.
struct outcome {
  std::map<std::pair<int, int>, double> bonds;
  std::vector<double> films;
  bond_events first, second;
  double before, after;
};

template <class Liquid>
outcome settled(const Liquid& policies, const scene& s) {
  auto b = bonds_of(policies, s.grains, s.volume, s.film);
  outcome o;
  o.before = b.book().total();
  o.first = s.grains.settle(b, s.gap, s.before);
  o.second = s.grains.settle(b, s.before, s.gap);
  o.after = b.book().total();
  for (std::size_t p = 0; p < s.gap.size(); ++p) {
    o.bonds[{s.grains.first[p], s.grains.second[p]}] = b.book().bonds()[p];
    REQUIRE(b.book().bonds()[p] >= 0);
  }
  o.films.assign(b.book().films().begin(), b.book().films().end());
  return o;
}

template <class Liquid>
void check_every_order(const Liquid& policies, bool forms) {
  std::int64_t ruptures = 0, formations = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const scene s = of_many_events(seed);
    const outcome one = settled(policies, s);
    ruptures += one.first.ruptures;
    formations += one.first.formations + one.second.formations;
    CHECK(std::abs(one.after - one.before) <= 1e-13 * one.before);
    for (std::uint64_t order = 1; order <= 10; ++order) {
      const outcome other = settled(policies, shuffled(s, order));
      CHECK(other.first.ruptures == one.first.ruptures);
      CHECK(other.first.formations == one.first.formations);
      CHECK(other.second.formations == one.second.formations);
      CHECK((other.bonds == one.bonds));
      CHECK((other.films == one.films));
    }
  }
  CHECK(ruptures > 50);
  CHECK((formations > 10) == forms);
}
template <class Bonds>
bool has_event(const Bonds& b, std::size_t first, const block& gap, const block& before) {
  return any(b.event(first, gap, before) > 0);
}
}  // namespace

TEST_CASE("many ruptures and formations of one step do not depend on the order of the pairs, to the last bit") {
  const volume_is_distance law{};
  SECTION("P0") { check_every_order(wet(law, protocol::neighbours{}), true); }
  SECTION("P2") { check_every_order(wet(law, protocol::grain_films{}), true); }
  SECTION("P3") { check_every_order(wet(law, protocol::gravity{}), true); }
  SECTION("no protocol") { check_every_order(wet(law), false); }
  SECTION("P0 across gaps") {
    check_every_order(wet(law, protocol::neighbours{}, formation::within_rupture_distance{}), true);
  }
  SECTION("P2 across gaps") {
    check_every_order(wet(law, protocol::grain_films{}, formation::within_rupture_distance{}), true);
  }
}

TEST_CASE("what the bridges of a grain lose in one step is all in its film") {
  // A star: grain 0 of radius 2 in the middle of five grains of radius 1, 2, 6, 2, 1; all bridges of 0.12 break.
  packing star;
  star.radius = {2, 1, 2, 6, 2, 1};
  star.pairs = {{0, 3}, {0, 1}, {0, 5}, {0, 4}, {0, 2}};
  star.listed();
  auto b = bonds_of(wet(volume_is_distance{}), star, {0.12, 0.12, 0.12, 0.12, 0.12}, {});
  const bond_events e = star.settle(b, {0.2, 0.2, 0.2, 0.2, 0.2});
  CHECK(e.ruptures == 5);
  CHECK(b.book().films()[0] == within(1e-14, 0.03 + 0.08 + 0.08 + 0.06 + 0.06));
  CHECK(b.book().films()[1] == within(1e-14, 0.04));
  CHECK(b.book().films()[3] == within(1e-14, 0.09));
  CHECK(b.book().films()[4] == within(1e-14, 0.06));
  CHECK(b.count() == 0);
}

TEST_CASE("a film that a rupture has just filled feeds a dry contact that closes in the same step") {
  packing c;
  c.radius = {1, 1, 1};
  for (const bool reversed : {false, true}) {
    c.pairs = reversed ? std::vector<listed_pair>{{1, 2}, {0, 1}} : std::vector<listed_pair>{{0, 1}, {1, 2}};
    c.listed();
    const std::size_t breaking = reversed ? 1 : 0, forming = 1 - breaking;
    std::vector<double> volume(2, 0.0), gap(2, -1e-3);
    volume[breaking] = 0.2;
    gap[breaking] = 0.3;
    auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}), c, volume, {});
    const bond_events e = c.settle(b, gap);
    CHECK((e.ruptures == 1 && e.formations == 1));
    CHECK(b.book().bonds()[forming] == 0.1);
    CHECK((b.book().films()[0] == 0.1 && b.book().films()[1] == 0));
  }
}

TEST_CASE("a contact that closed dry takes no film before it has opened and closes again") {
  packing c;
  c.radius = {1, 1, 1};
  c.pairs = {{0, 1}, {1, 2}};
  c.listed();
  const auto check = [&](auto protocol) {
    auto b = bonds_of(wet(volume_is_distance{}, protocol), c, {0.2, 0.0}, {});
    CHECK(c.settle(b, {0.1, -1e-3}, {0.1, 0.1}).formations == 0);    // 1 and 2 meet while their films are empty
    CHECK(c.settle(b, {0.3, -1e-3}, {0.1, -1e-3}).ruptures == 1);    // 0 and 1 part: grain 1 has a film
    CHECK(c.settle(b, {0.3, -2e-3}, {0.3, -1e-3}).formations == 0);  // and still it is not a new contact
    CHECK(c.settle(b, {0.3, 1e-3}, {0.3, -2e-3}).formations == 0);   // open
    CHECK(b.book().films()[1] == 0.1);
    CHECK(c.settle(b, {0.3, -1e-3}, {0.3, 1e-3}).formations == 1);
    CHECK(b.book().bonds()[1] == 0.1);
  };
  check(protocol::grain_films{});
  check(protocol::neighbours{});
}

TEST_CASE("a gap of exactly 0 is open, and closing from there is closing") {
  packing c;
  c.radius = {1, 1};
  c.pairs = {{0, 1}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}), c, {}, {0.1, 0.1});
  const auto at = [](double gap) { return block(gap); };
  CHECK_FALSE((b.forms(0, 0, 0.1) || has_event(b, 0, at(0), at(0.1))));
  CHECK((b.forms(0, -1e-9, 0) && has_event(b, 0, at(-1e-9), at(0))));
  CHECK((b.forms(0, -1e-9, 1e-9) && has_event(b, 0, at(-1e-9), at(1e-9))));
  CHECK_FALSE((b.forms(0, -1e-9, -1e-12) || has_event(b, 0, at(-1e-9), at(-1e-12))));
}

TEST_CASE("bridges that break together see each other's liquid when they may form anew across the gap") {
  // 0 - 1 and 1 - 2 break; the films of 0 and 1 then hold 0.3, enough to reach across the 0.25 between them.
  packing c;
  c.radius = {1, 1, 1};
  for (const bool reversed : {false, true}) {
    c.pairs = reversed ? std::vector<listed_pair>{{1, 2}, {0, 1}} : std::vector<listed_pair>{{0, 1}, {1, 2}};
    c.listed();
    const std::vector<double> gap = reversed ? std::vector<double>{0.5, 0.25} : std::vector<double>{0.25, 0.5};
    auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}, formation::within_rupture_distance{}), c,
                      {0.2, 0.2}, {});
    const bond_events e = c.settle(b, gap);
    CHECK((e.ruptures == 2 && e.formations == 1));
    CHECK(b.book().bonds()[reversed ? 1 : 0] == within(1e-15, 0.3));
  }
}

TEST_CASE("an event is announced for the block that has it, and after it is settled no more") {
  packing c;
  for (int k = 0; k < 20; ++k) c.radius.push_back(1);
  for (int k = 0; k < 19; ++k) c.pairs.push_back({k, k + 1});
  c.listed();
  std::vector<double> volume(19, 0.1), gap(19, -1e-3);
  auto b = bonds_of(wet(volume_is_distance{}, protocol::neighbours{}), c, volume, {});
  gap[10] = 0.2;
  std::vector<double> padded_gap = gap;
  padded_gap.resize(24, gap.back());
  const auto announced = [&](std::size_t first) {
    const block now = load(padded_gap.data() + first);
    return has_event(b, first, now, now);
  };
  CHECK_FALSE(announced(0));
  CHECK(announced(8));
  CHECK_FALSE(announced(16));
  CHECK(c.settle(b, gap).ruptures == 1);
  for (const std::size_t first : {0u, 8u, 16u}) CHECK_FALSE(announced(first));
}

TEST_CASE("pairs without a bridge, broken ones and padding pull with nothing, the others by the law") {
  packing c;
  c.radius = {1, 1, 1, 1};
  c.pairs = {{0, 1}, {1, 2}, {2, 3}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}), c, {0.1, 0.0, 0.1}, {});
  std::vector<double> gap{0.05, 0.05, 0.11, -1, -1, 1, 1, 1};
  const block pull = b.attraction(0, load(gap.data()));
  const double expected = capillary::richefeu{}.attraction(bridge<double>{0.05, 0.1, 1, 1}, fluid::water());
  CHECK(pull[0] == within(1e-14, expected));
  for (int k = 1; k < 8; ++k) CHECK(pull[k] == 0);
  CHECK(b.any_bonded(0));
}

TEST_CASE("the energy book of the bridges gets what forming, refilling and breaking sets free") {
  packing c;
  c.radius = {1, 1};
  c.pairs = {{0, 1}};
  c.listed();
  const auto policies = wet(volume_is_distance{}, protocol::grain_films{});
  const auto held = [&](double gap, double volume) {
    return capillary::richefeu{}.energy(bridge<double>{gap, volume, 1, 1}, fluid::water(), volume);
  };
  auto b = bonds_of(policies, c, {}, {0.1, 0.1});
  CHECK(b.work() == 0);
  c.settle(b, {-0.01});
  CHECK(b.work() == within(1e-13, held(-0.01, 0.2)));
  CHECK(b.energy(0, 0.05, c.view()) == within(1e-13, held(0.05, 0.2)));
  CHECK(b.energy(0, 0.21, c.view()) == 0);
  b.introduce(0.1);
  b.move(ledger::reservoir(), ledger::bond_of(0), 0.1, 0, 0.05, c.view());
  CHECK(b.work() == within(1e-13, held(-0.01, 0.2) + held(0.05, 0.3) - held(0.05, 0.2)));
  const double before = b.work();
  c.settle(b, {0.4});  // beyond rupture there is nothing left to lose
  CHECK(b.work() == before);
}

TEST_CASE("a bridge whose pair is no longer listed stops the run") {
  packing c;
  c.radius = {1, 1, 1};
  c.pairs = {{0, 1}, {1, 2}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}), c, {0.1, 0.2}, {});
  packing fewer = c;
  fewer.pairs = {{1, 2}};
  fewer.listed();
  const std::array<std::int32_t, 1> origin{1};
  CHECK_THROWS_AS(b.carry(origin, fewer.view()), run_error);
}

TEST_CASE("bridges follow their pairs into a new list with volume, threshold and force") {
  packing c;
  c.radius = {1, 1, 1};
  c.pairs = {{0, 1}, {1, 2}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}), c, {0.1, 0.2}, {});
  packing turned = c;
  turned.pairs = {{1, 2}, {0, 2}, {0, 1}};
  turned.listed();
  b.carry(std::array<std::int32_t, 3>{1, -1, 0}, turned.view());
  CHECK((b.book().bonds()[0] == 0.2 && b.book().bonds()[1] == 0 && b.book().bonds()[2] == 0.1));
  CHECK((b.breaks_above(0) == 0.2 && b.breaks_above(2) == 0.1 && b.count() == 2));
  std::vector<double> gap(8, 0.05);
  const block pull = b.attraction(0, load(gap.data()));
  CHECK(pull[0] == within(1e-14, capillary::richefeu{}.attraction(bridge<double>{0.05, 0.2, 1, 1}, fluid::water())));
  CHECK(pull[1] == 0);
  CHECK(b.reach(turned.view()) == 0.2);
}

TEST_CASE("the list must see as far as films could join grains, and no farther than the longest bridge without") {
  packing c;
  c.radius = {1, 2};
  c.pairs = {{0, 1}};
  c.listed();
  const volume_is_distance law{};
  CHECK(bonds_of(wet(law), c, {0.1}, {0.3, 0.4}).reach(c.view()) == 0.1);
  CHECK(bonds_of(wet(law, protocol::grain_films{}), c, {0.1}, {0.3, 0.4}).reach(c.view()) == 0.1);
  CHECK(bonds_of(wet(law, protocol::grain_films{}, formation::within_rupture_distance{}), c, {0.1}, {0.3, 0.4})
            .reach(c.view()) >= 0.7);
}

TEST_CASE("the list must see as far as films could join the largest grains, and the smallest") {
  packing c;
  c.radius = {1, 2};
  c.pairs = {{0, 1}};
  c.listed();
  const auto policies = wet(tenth_of_the_radius{}, protocol::grain_films{}, formation::within_rupture_distance{});
  CHECK(bonds_of(policies, c, {}, {0.3, 0.4}).reach(c.view()) == 0.2);
}
