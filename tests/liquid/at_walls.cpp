// SPDX-License-Identifier: BSD-3-Clause
// Grains near a wall as rows of the bonds, and what the protocols do there, in numbers worked out by hand.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <set>

using namespace pendular;
using namespace hand_made;

namespace {
/// Grains 0 and 1, radii 1 and 3, in contact and both on a floor.
packing on_floor() {
  packing c;
  c.radius = {1, 3};
  c.position = {{0, 0, 1}, {2 * std::sqrt(3.0), 0, 3}};
  c.pairs = {{0, 1}};
  c.floor = {{0, 0, 0.0, {0, 0, -1}}, {1, 0, 0.0, {0, 0, -1}}};
  return c.listed();
}

constexpr std::size_t pair = 0, floor_0 = lane_count, floor_1 = lane_count + 1;

/// Per row of the bonds, apart but for the given ones.
std::vector<double> gaps(std::initializer_list<std::pair<std::size_t, double>> some) {
  std::vector<double> all(2 * lane_count, 1.0);
  for (const auto& [row, gap] : some) all[row] = gap;
  return all;
}
}  // namespace

TEST_CASE("the grains at a wall follow the pairs, with ids, gaps and bridges of their own") {
  const packing c = on_floor();
  const pair_view v = c.view();
  CHECK(v.rows() == 2 * lane_count);
  std::set<std::size_t> real;
  v.for_each_row([&](std::size_t p) { real.insert(p); });
  CHECK(real == std::set<std::size_t>{pair, floor_0, floor_1});
  CHECK((v.is_at_wall(floor_0) && !v.is_at_wall(pair) && v.is_padding(floor_1 + 1)));
  CHECK((v.ids(floor_1) == std::pair<std::int64_t, std::int64_t>{1, -1}));
  CHECK(is_at_wall(v.bridge_of(floor_1, 0, 1)));
  CHECK_FALSE(is_at_wall(v.bridge_of(pair, 0, 1)));
  CHECK(bond_size(v.bridge_of(floor_1, 0, 1)) == 27);
  CHECK(bond_size(v.bridge_of(pair, 0, 1)) == within(1e-15, std::pow(3, 1.5)));
  const bond_side s = v.side(floor_1, 1, true);
  CHECK((s.own_radius == 3 && s.partner_radius == 3 && s.contact_height == -3 && s.partner == -1 && s.forming));
  for (const std::size_t grain : {0u, 1u}) {
    std::vector<std::size_t> rows;
    v.for_each_wall_row_of(grain, [&](std::size_t p) { rows.push_back(p); });
    CHECK(rows == std::vector<std::size_t>{lane_count + grain});
  }
}

TEST_CASE("under P0 a wall weighs as much as a grain of the same size") {
  const packing c = on_floor();
  auto b = bonds_of(wet(volume_is_distance{}, protocol::neighbours{}), c, {0.2}, {0.4, 0.8});
  for (const std::size_t p : {floor_0, floor_1}) {
    b.introduce(0.1);
    b.move(ledger::reservoir(), ledger::bond_of(p), 0.1, p, 0.0, c.view());
  }
  c.settle(b, gaps({{pair, -1e-3}, {floor_0, -1e-3}, {floor_1, -1e-3}}));
  // film of 0: 3 parts to the pair, 1 to the floor; film of 1: 1 part to the pair, 3 to the floor
  CHECK(b.book().bonds()[pair] == within(1e-14, 0.2 + 0.3 + 0.2));
  CHECK(b.book().bonds()[floor_0] == within(1e-14, 0.1 + 0.1));
  CHECK(b.book().bonds()[floor_1] == within(1e-14, 0.1 + 0.6));
  CHECK(b.book().total() == within(1e-15, 1.6));
}

TEST_CASE("under P3 the film runs to the floor, under P2 to the wall that is newly touched") {
  const packing c = on_floor();
  auto p3 = bonds_of(wet(volume_is_distance{}, protocol::gravity{}), c, {0.2}, {0.4, 0.0});
  p3.introduce(0.1);
  p3.move(ledger::reservoir(), ledger::bond_of(floor_0), 0.1, floor_0, 0.0, c.view());
  c.settle(p3, gaps({{pair, -1e-3}, {floor_0, -1e-3}}));
  CHECK(p3.book().bonds()[floor_0] == within(1e-14, 0.5));
  CHECK(p3.book().bonds()[pair] == 0.2);

  auto p2 = bonds_of(wet(volume_is_distance{}, protocol::grain_films{}), c, {0.2}, {0.4, 0.3});
  const auto now = gaps({{pair, -1e-3}, {floor_0, -1e-3}, {floor_1, -1e-3}});
  const bond_events e = c.settle(p2, now, gaps({{pair, -1e-3}, {floor_1, -1e-3}}));  // grain 1 was there before
  CHECK((e.formations == 1 && p2.book().bonds()[floor_0] == 0.4 && p2.book().bonds()[floor_1] == 0));
  CHECK(p2.book().films()[1] == 0.3);
}

TEST_CASE("a bridge broken at a wall leaves all its liquid to the grain") {
  const packing c = on_floor();
  auto b = bonds_of(wet(volume_is_distance{}), c, {0.2}, {});
  b.introduce(0.1);
  b.move(ledger::reservoir(), ledger::bond_of(floor_1), 0.1, floor_1, 0.0, c.view());
  const bond_events e = c.settle(b, gaps({{pair, -1e-3}, {floor_1, 0.11}}));
  CHECK((e.ruptures == 1 && b.book().films()[1] == 0.1 && b.book().films()[0] == 0 && b.count() == 1));
}

TEST_CASE("the homogeneous share goes over pairs and walls by their sizes") {
  const packing c = on_floor();
  auto b = bonds_of(wet(rupture::lian{}, protocol::homogeneous{}), c, {}, {});
  const double sizes = std::pow(3, 1.5) + 1 + 27;
  b.introduce(1e-3 * sizes);
  const bond_events e = distribute(b, c.view(), {});
  CHECK(e.formations == 3);
  CHECK(b.book().bonds()[pair] == within(1e-13, 1e-3 * std::pow(3, 1.5)));
  CHECK(b.book().bonds()[floor_0] == within(1e-13, 1e-3));
  CHECK(b.book().bonds()[floor_1] == within(1e-13, 27e-3));
}
