// SPDX-License-Identifier: BSD-3-Clause
// The moves of the protocols on one grain, then what becomes of the liquid of broken bonds and of films, in numbers
// worked out by hand from the formulas of the protocols: V_i = V D_i / (D_i + D_j), and the shares below.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <pendular/liquid/protocol/one_of.hpp>

#include <cmath>

using namespace pendular;
using namespace hand_made;

namespace {
/// A grain's own view of a bond: radius of the partner, height of the contact point, partner, forming.
bond_side side(double partner_radius, double height, std::int64_t partner, bool forming = false) {
  return {1, partner_radius, height, partner, forming};
}

// A chain 0 - 1 - 2 - 3 with radii 1, 2, 1, 3 on a horizontal line; pair 1 (grains 1 and 2) is the one that breaks.
packing chain() {
  packing c;
  c.radius = {1, 2, 1, 3};
  c.position = {{0, 0, 0}, {3, 0, 0}, {6.5, 0, 0}, {10.5, 0, 0}};
  c.pairs = {{0, 1}, {1, 2}, {2, 3}};
  return c.listed();
}
const std::vector<double> chain_gaps{-1e-3, 0.5, -1e-3};
}  // namespace

TEST_CASE("P0 weighs bonds by the diameters of the partners") {
  const protocol::neighbours p0{};
  const auto merged = p0.merge(p0.merge(p0.offer(side(1, 0, 1)), p0.offer(side(2, 0, 2))), p0.offer(side(3, 0, 3)));
  const auto grant = p0.settle(merged, 1.2);  // 12 m of diameters
  CHECK(p0.pull(side(1, 0, 1), grant) == within(1e-15, 0.2));
  CHECK(p0.pull(side(2, 0, 2), grant) == within(1e-15, 0.4));
  CHECK(p0.pull(side(3, 0, 3), grant) == within(1e-15, 0.6));
}

TEST_CASE("P2 shares equally among the new contacts and gives the old ones nothing") {
  const protocol::grain_films p2{};
  const auto merged =
      p2.merge(p2.merge(p2.offer(side(1, 0, 1, true)), p2.offer(side(2, 0, 2, false))), p2.offer(side(3, 0, 3, true)));
  const auto grant = p2.settle(merged, 1.2);
  CHECK(p2.pull(side(1, 0, 1, true), grant) == within(1e-15, 0.6));
  CHECK(p2.pull(side(2, 0, 2, false), grant) == 0);
  CHECK(p2.pull(side(3, 0, 3, true), grant) == within(1e-15, 0.6));
  CHECK(p2.pull(side(2, 0, 2, false), p2.settle(p2.offer(side(2, 0, 2, false)), 1.2)) == 0);
}

TEST_CASE("P3 gives all to the lowest contact below the centre, the lower partner id if two are equally low") {
  const protocol::gravity p3{};
  const auto grant_of = [&](std::initializer_list<bond_side> sides) {
    auto merged = p3.offer(*sides.begin());
    for (const bond_side& s : sides) merged = p3.merge(merged, p3.offer(s));
    return p3.settle(merged, 1.2);
  };
  const auto low = grant_of({side(1, 0.5, 1), side(1, -0.2, 2), side(1, -0.7, 3)});
  CHECK(p3.pull(side(1, 0.5, 1), low) == 0);
  CHECK(p3.pull(side(1, -0.2, 2), low) == 0);
  CHECK(p3.pull(side(1, -0.7, 3), low) == 1.2);
  for (const auto& tie :
       {grant_of({side(1, -0.7, 4), side(1, -0.7, 2)}), grant_of({side(1, -0.7, 2), side(1, -0.7, 4)})}) {
    CHECK(p3.pull(side(1, -0.7, 2), tie) == 1.2);
    CHECK(p3.pull(side(1, -0.7, 4), tie) == 0);
  }
  const auto nobody = grant_of({side(1, 0.5, 1), side(1, 0, 2)});  // a contact at the equator is not below the centre
  CHECK(p3.pull(side(1, 0.5, 1), nobody) == 0);
  CHECK(p3.pull(side(1, 0, 2), nobody) == 0);
  CHECK(p3.pull(side(1, 0, 2), grant_of({side(1, 0, 2)})) == 0);
}

TEST_CASE("the side of a bond knows the height of its contact point") {
  packing tower;
  tower.radius = {1, 2};
  tower.position = {{0, 0, 0}, {0, 2.4, 3.2}};  // 4 apart, a gap of 1, along (0, 0.6, 0.8)
  tower.pairs = {{0, 1}};
  tower.listed();
  const pair_view v = tower.view();
  CHECK(v.gap(0) == within(1e-14, 1));
  // the contact point is in the middle of the gap: 1.5 from grain 0 and 2.5 from grain 1
  CHECK(v.side(0, 0, true).contact_height == within(1e-14, 1.2));
  CHECK(v.side(0, 1, true).contact_height == within(1e-14, -2.0));
  const bond_side s = v.side(0, 1, true);
  CHECK((s.own_radius == 2 && s.partner_radius == 1 && s.partner == 0 && s.forming));
  CHECK_FALSE(v.side(0, 0, false).forming);
}

TEST_CASE("a protocol chosen at run time does what it does chosen at compile time") {
  using any = protocol::one_of<protocol::neighbours, protocol::grain_films, protocol::gravity>;
  static_assert(LocalProtocol<any> && any::needs_gravity);
  const packing c = chain();
  const auto settled = [&](const auto& p) {
    auto b = bonds_of(wet(volume_is_distance{}, p), c, {0.1, 0.3, 0.0}, {0.02, 0.01, 0.03, 0.04});
    c.settle(b, chain_gaps);
    std::vector<double> found(b.book().bonds().begin(), b.book().bonds().end());
    found.insert(found.end(), b.book().films().begin(), b.book().films().end());
    return found;
  };
  const auto check = [&](const auto& p) { CHECK(settled(any(p)) == settled(p)); };
  check(protocol::neighbours{});
  check(protocol::grain_films{});
  check(protocol::gravity{});
  CHECK(settled(protocol::neighbours{}) != settled(protocol::grain_films{}));
}

TEST_CASE("a broken bridge is split in proportion to the diameters, and stays on the grains without a protocol") {
  const packing c = chain();
  auto b = bonds_of(wet(volume_is_distance{}), c, {0.1, 0.3, 0.2}, {});
  const bond_events e = c.settle(b, chain_gaps);
  CHECK((e.ruptures == 1 && e.formations == 0));
  CHECK(b.book().films()[1] == within(1e-15, 0.2));
  CHECK(b.book().films()[2] == within(1e-15, 0.1));
  CHECK((b.book().bonds()[0] == 0.1 && b.book().bonds()[1] == 0 && b.book().bonds()[2] == 0.2));
  CHECK(b.book().total() == within(1e-15, 0.6));
  // it is not broken twice, and nothing touches the films again
  CHECK(c.settle(b, chain_gaps).ruptures == 0);
  CHECK(b.book().films()[1] == within(1e-15, 0.2));
}

TEST_CASE("a bridge holds up to its rupture distance and breaks beyond") {
  const packing c = chain();
  auto b = bonds_of(wet(volume_is_distance{}), c, {0.1, 0.3, 0.2}, {});
  CHECK((b.breaks_above(0) == 0.1 && b.breaks_above(1) == 0.3));
  CHECK_FALSE(b.breaks(1, 0.3));
  CHECK(b.breaks(1, std::nextafter(0.3, 1)));
  CHECK(c.settle(b, {0.1, 0.3, 0.2}).ruptures == 0);
  CHECK(c.settle(b, {0.1, std::nextafter(0.3, 1), 0.2}).ruptures == 1);
}

TEST_CASE("P0 hands the liquid of a broken bridge to the neighbouring bridges of each grain") {
  packing c = chain();
  c.radius = {1, 2, 1, 3, 2};  // a fifth grain also joined to grain 2
  c.position.push_back({6.5, 3, 0});
  c.pairs.push_back({2, 4});
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::neighbours{}), c, {0.1, 0.3, 0.2, 0.4}, {});
  const bond_events e = c.settle(b, {-1e-3, 0.5, -1e-3, -1e-3});
  CHECK((e.ruptures == 1 && e.formations == 0));
  // grain 1 gets 0.2, all for its only neighbour; grain 2 gets 0.1, shared 3 : 2 between partners of radius 3 and 2
  CHECK(b.book().bonds()[0] == within(1e-14, 0.3));
  CHECK(b.book().bonds()[1] == 0);
  CHECK(b.book().bonds()[2] == within(1e-14, 0.26));
  CHECK(b.book().bonds()[3] == within(1e-14, 0.44));
  for (const double film : b.book().films()) CHECK(film == near(1e-16, 0));
  CHECK(b.breaks_above(2) == within(1e-14, 0.26));  // the thresholds follow
}

TEST_CASE("P0 keeps the film of a grain without another bridge and offers it again") {
  packing c;
  c.radius = {1, 1, 1};
  c.pairs = {{0, 1}, {1, 2}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::neighbours{}), c, {0.2, 0.0}, {});
  c.settle(b, {0.5, 0.01});
  CHECK((b.book().films()[0] == 0.1 && b.book().films()[1] == 0.1 && b.count() == 0));
  c.settle(b, {0.5, 0.01});
  CHECK((b.book().films()[0] == 0.1 && b.book().films()[1] == 0.1));
  // now 1 and 2 touch: the film of 1 becomes a bridge, that of 0 stays
  const bond_events e = c.settle(b, {0.5, -0.01});
  CHECK(e.formations == 1);
  CHECK((b.book().bonds()[1] == 0.1 && b.book().films()[0] == 0.1 && b.book().films()[1] == 0));
}

TEST_CASE("P2 keeps films until a contact forms and joins both films there") {
  const packing c = chain();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}), c, {0.1, 0.3, 0.2}, {});
  c.settle(b, chain_gaps);
  CHECK(b.book().films()[1] == within(1e-15, 0.2));
  CHECK(b.book().films()[2] == within(1e-15, 0.1));
  CHECK((b.book().bonds()[0] == 0.1 && b.book().bonds()[2] == 0.2));  // old contacts get nothing
  CHECK_FALSE(b.forms(1, 0.01, 0.02));                                // near is not enough
  CHECK(b.forms(1, -1e-9, 0.01));
  const bond_events e = c.settle(b, {-1e-3, -1e-3, -1e-3});
  CHECK((e.ruptures == 0 && e.formations == 1));
  CHECK(b.book().bonds()[1] == within(1e-15, 0.3));
  CHECK((b.book().films()[1] == 0 && b.book().films()[2] == 0));
}

TEST_CASE("P2 shares a film equally among the contacts that form in one step, whatever their size") {
  packing c;
  c.radius = {1, 1, 4, 2};
  c.pairs = {{0, 1}, {0, 2}, {0, 3}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}), c, {}, {0.6, 0.1, 0, 0.05});
  const bond_events e = c.settle(b, {-1e-3, -1e-3, 0.01});
  CHECK(e.formations == 2);
  CHECK(b.book().bonds()[0] == within(1e-15, 0.4));  // half of 0.6 and all of 0.1
  CHECK(b.book().bonds()[1] == within(1e-15, 0.3));
  CHECK(b.book().bonds()[2] == 0);
  CHECK(b.book().films()[3] == 0.05);
}

TEST_CASE("P3 lets the liquid of both grains run to their lowest bridges") {
  // Grain 1 (radius 2) breaks from grain 0 (radius 1); below 1 hang grains 2 and 3, 3 is lower. Grain 0 has none below.
  packing c;
  c.radius = {1, 2, 1, 1, 1};
  c.position = {{0, 0, 0}, {3.5, 0, 0}, {5.9, 0, -1.8}, {3.5, 1.8, -2.4}, {0, 0, 2}};
  c.pairs = {{0, 1}, {1, 2}, {1, 3}, {0, 4}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::gravity{}), c, {0.3, 0.1, 0.1, 0.1}, {});
  const bond_events e = c.settle(b, {0.5, -1e-3, -1e-3, -1e-3});
  CHECK(e.ruptures == 1);
  CHECK(b.book().bonds()[1] == 0.1);
  CHECK(b.book().bonds()[2] == within(1e-14, 0.3));  // 2/3 of 0.3
  CHECK(b.book().bonds()[3] == 0.1);                 // above grain 0
  CHECK(b.book().films()[0] == within(1e-14, 0.1));
  CHECK(b.book().films()[1] == 0);
  // upside down the same film finds the bridge to grain 4
  c.up = {0, 0, -1};
  c.settle(b, {0.5, -1e-3, -1e-3, -1e-3});
  CHECK(b.book().bonds()[3] == within(1e-14, 0.2));
  CHECK(b.book().films()[0] == 0);
}

TEST_CASE("a bridge below the minimum volume is not formed and its liquid stays on the grains") {
  packing c;
  c.radius = {1, 4};  // R^3 = 8
  c.pairs = {{0, 1}};
  c.listed();
  const auto policies = wet(volume_is_distance{}, protocol::grain_films{}, formation::at_contact{0.01});
  auto poor = bonds_of(policies, c, {}, {0.05, 0.0299});
  CHECK(c.settle(poor, {-1e-3}).formations == 0);
  CHECK((poor.book().films()[0] == 0.05 && poor.book().films()[1] == 0.0299 && !poor.is_bonded(0)));
  auto rich = bonds_of(policies, c, {}, {0.05, 0.0301});
  CHECK(c.settle(rich, {-1e-3}).formations == 1);
  CHECK(rich.book().bonds()[0] == within(1e-15, 0.0801));
}

TEST_CASE("a share below the minimum volume stays even where the whole film would do") {
  packing c;
  c.radius = {1, 1, 1, 1};
  c.pairs = {{0, 1}, {0, 2}, {0, 3}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}, formation::at_contact{0.01}), c, {},
                    {0.024, 0.005, 0, 0});
  const bond_events e = c.settle(b, {-1e-3, -1e-3, -1e-3});
  CHECK(e.formations == 1);  // 0.008 each: only the first, with 0.005 from its other grain, is a bridge
  CHECK(b.book().bonds()[0] == within(1e-14, 0.013));
  CHECK(b.book().films()[0] == within(1e-14, 0.016));
}

TEST_CASE("a bridge forms across a gap only if it would not break at once") {
  packing c;
  c.radius = {1, 1};
  c.pairs = {{0, 1}};
  c.listed();
  const auto policies = wet(volume_is_distance{}, protocol::grain_films{}, formation::within_rupture_distance{});
  auto b = bonds_of(policies, c, {}, {0.2, 0.1});
  CHECK(b.forms_below(0) == within(1e-15, 0.3));
  CHECK(c.settle(b, {0.31}).formations == 0);
  CHECK(c.settle(b, {0.29}).formations == 1);
  CHECK_FALSE(b.breaks(0, 0.29));
}

TEST_CASE("a share that would break at once makes no bridge, even where the whole film would hold") {
  packing c;
  c.radius = {1, 1, 1};
  c.pairs = {{0, 1}, {0, 2}};
  c.listed();
  const auto policies = wet(volume_is_distance{}, protocol::grain_films{}, formation::within_rupture_distance{});
  auto b = bonds_of(policies, c, {}, {0.4, 0, 0});
  CHECK(c.settle(b, {0.3, 0.25}).formations == 0);  // 0.2 for each
  CHECK(b.book().films()[0] == 0.4);
  CHECK(c.settle(b, {0.3, 1}).formations == 1);
}

TEST_CASE("films do not make bridges by themselves without a protocol") {
  packing c;
  c.radius = {1, 1};
  c.pairs = {{0, 1}};
  c.listed();
  auto b = bonds_of(wet(volume_is_distance{}), c, {}, {0.2, 0.1});
  CHECK_FALSE(b.forms(0, -0.1, 0.1));
  CHECK(c.settle(b, {-0.1}).formations == 0);
}
