// SPDX-License-Identifier: BSD-3-Clause
// The homogeneous distribution (Eqs. 13-14 of Richefeu et al. 2007) carried out on the ledger, and in a small scene.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <pendular/boundary/plane.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numeric>

using namespace pendular;
using namespace hand_made;

namespace {
/// A row of six grains of radii 1, 2, 1, 2, 1, 2, each a little into the next; then one at a gap of 0.1 and one far off.
packing row_of_grains() {
  packing row;
  row.radius = {1, 2, 1, 2, 1, 2, 1, 1};
  double x = 0;
  for (std::size_t k = 0; k < row.radius.size(); ++k) {
    const double gap = k == 6 ? 0.1 : k == 7 ? 2 : -1e-6;
    if (k > 0) x += row.radius[k - 1] + row.radius[k] + gap;
    row.position.push_back({x, 0, 0});
  }
  for (std::int32_t k = 0; k < 7; ++k) row.pairs.push_back({k, k + 1});
  return row.listed();
}

template <class Liquid>
bonds<Liquid> dry_bonds(const Liquid& policies, const packing& grains) {
  return bonds_of(policies, grains, {}, {});
}
}  // namespace

TEST_CASE("a homogeneous distribution gives every pair in reach V_b = alpha R^3 and keeps none back") {
  const packing row = row_of_grains();
  auto b = dry_bonds(wet(rupture::lian{}, protocol::homogeneous{}), row);
  // Six pairs of radii 1 and 2 have R^3 = sqrt(8); the one at a gap of 0.1 then needs alpha = 1e-3 / sqrt(8).
  b.introduce(0.06);
  const bond_events e = distribute(b, row.view(), {});
  CHECK((e.formations == 6 && e.ruptures == 0));
  for (std::size_t p = 0; p < 6; ++p) CHECK(b.book().bonds()[p] == within(1e-14, 0.01));
  CHECK(b.book().bonds()[6] == 0);
  CHECK(b.book().total() == within(1e-15, 0.06));
  CHECK(std::abs(b.book().balance(ledger::reservoir())) < 1e-16);
  CHECK(b.breaks_above(5) == within(1e-14, std::cbrt(0.01)));
}

TEST_CASE("liquid that is too little for the open pair stays between the touching ones") {
  const packing row = row_of_grains();
  auto b = dry_bonds(wet(rupture::lian{}, protocol::homogeneous{}), row);
  b.introduce(0.0055);  // 1.1e-3 each for five, but 0.917e-3 each for six does not reach across 0.1
  CHECK(distribute(b, row.view(), {}).formations == 5);
  for (std::size_t p = 0; p < 5; ++p) CHECK(b.book().bonds()[p] == within(1e-14, 0.0011));
  CHECK(b.book().bonds()[5] == 0);
}

TEST_CASE("bridges and films of before are collected first, and only real changes count as events") {
  const packing row = row_of_grains();
  auto b = bonds_of(wet(rupture::lian{}, protocol::homogeneous{}), row, {0.03, 0, 0, 0, 0, 0, 0.01},
                    {0, 0.02, 0, 0, 0, 0, 0, 0});
  const bond_events e = distribute(b, row.view(), {});
  CHECK((e.formations == 5 && e.ruptures == 1));  // pair 6 lost its bridge, pair 0 kept one
  for (std::size_t p = 0; p < 6; ++p) CHECK(b.book().bonds()[p] == within(1e-14, 0.01));
  for (const double film : b.book().films()) CHECK(film == 0);
  CHECK(b.book().total() == within(1e-15, 0.06));
}

TEST_CASE("a thinned distribution gives the pairs it keeps more, the others nothing") {
  packing many;
  for (int k = 0; k < 401; ++k) {
    many.radius.push_back(1);
    many.position.push_back({2.0 * k, 0, 0});
  }
  for (std::int32_t k = 0; k < 400; ++k) many.pairs.push_back({k, k + 1});
  many.listed();
  const bond_selection half{2, 5};
  auto b = dry_bonds(wet(rupture::lian{}), many);
  b.introduce(0.4);
  distribute(b, many.view(), half);
  std::size_t kept = 0;
  for (std::int64_t k = 0; k < 400; ++k) kept += half.keeps(k, k + 1) ? 1 : 0;
  CHECK(b.count() == kept);
  CHECK((kept > 150 && kept < 250));
  for (std::int64_t k = 0; k < 400; ++k) {
    const double expected = half.keeps(k, k + 1) ? 0.4 / static_cast<double>(kept) : 0;
    CHECK(b.book().bonds()[static_cast<std::size_t>(k)] == near(1e-15, expected));
  }
  CHECK(b.book().total() == within(1e-15, 0.4));
}

TEST_CASE("a thousand redistributions conserve the liquid") {
  const packing row = row_of_grains();
  auto b = dry_bonds(wet(rupture::lian{}, protocol::homogeneous{}), row);
  b.introduce(0.0061);
  for (int k = 0; k < 1000; ++k) distribute(b, row.view(), {1.5, static_cast<std::uint64_t>(k)});
  CHECK(std::abs(b.book().total() - 0.0061) < 1e-13 * 0.0061);
}

TEST_CASE("liquid below the minimum volume goes to the grains in proportion to R^3 and not into bridges") {
  const packing row = row_of_grains();  // sum of R^3 over the grains: 5 + 3 * 8 = 29
  auto b = dry_bonds(wet(rupture::lian{}, formation::at_contact{0.01}), row);
  b.introduce(0.029);
  CHECK(distribute(b, row.view(), {}).formations == 0);
  CHECK(b.count() == 0);
  CHECK(b.book().films()[0] == within(1e-14, 0.001));
  CHECK(b.book().films()[1] == within(1e-14, 0.008));
  CHECK(b.book().total() == within(1e-15, 0.029));
}

TEST_CASE("liquid that no pair can take goes to the grains even where there is no minimum volume") {
  packing two;
  two.radius = {1, 2};
  two.position = {{0, 0, 0}, {5, 0, 0}};
  two.pairs = {{0, 1}};
  two.listed();
  auto b = dry_bonds(wet(rupture::lian{}, formation::at_contact{0}), two);
  b.introduce(0.009);
  distribute(b, two.view(), {});
  CHECK(b.book().films()[0] == within(1e-14, 0.001));
  CHECK(b.book().films()[1] == within(1e-14, 0.008));
}

TEST_CASE("films of a distribution that reached no pair make a bridge at the first touch") {
  packing two;
  two.radius = {1, 1};
  two.position = {{0, 0, 0}, {2.5, 0, 0}};
  two.pairs = {{0, 1}};
  two.listed();
  auto b = dry_bonds(wet(rupture::lian{}, protocol::grain_films{}), two);
  b.introduce(0.01);
  CHECK(distribute(b, two.view(), {}).formations == 0);
  CHECK(b.book().films()[0] == 0.005);
  CHECK(b.forms(0, -1e-6, 1e-6));
  CHECK(two.settle(b, {-1e-6}).formations == 1);
  CHECK(b.book().bonds()[0] == within(1e-15, 0.01));
}

TEST_CASE("no pair expects a bridge from films that a distribution has taken away") {
  packing chain;
  chain.radius = {1, 1, 1};
  chain.position = {{0, 0, 0}, {2, 0, 0}, {4.3, 0, 0}};
  chain.pairs = {{0, 1}, {1, 2}};
  chain.listed();
  auto b = bonds_of(wet(rupture::lian{}, protocol::grain_films{}), chain, {0.001}, {0, 0, 0.001});
  CHECK(b.forms(1, -1e-6, 1e-6));
  distribute(b, chain.view(), {});
  CHECK(b.book().bonds()[0] == within(1e-15, 0.002));
  CHECK_FALSE(b.forms(1, -1e-6, 1e-6));
}

TEST_CASE("liquid reaches across gaps however thin the skin of the neighbour list is") {
  // Two grains of 1 mm at a gap of 0.3 mm, 0.1 mm3 of water: the bridge lives up to 0.464 mm. Nothing touches.
  for (const double skin : {0.05, 0.2, 0.5}) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.8}},
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::homogeneous{}},
                       boundary::walls{}, half_step_velocity_verlet{1e-7}, run_options{.skin = skin}};
    s.add({{0, 0, 0}, 1e-3, 2600});
    s.add({{2.3e-3, 0, 0}, 1e-3, 2600});
    s.distribute_liquid(1e-10);
    CHECK(s.bridges().count() == 1);
  }
}

TEST_CASE("a distribution finds the same bridges whatever the skin, in a scene where some grains touch") {
  std::vector<std::size_t> counts;
  for (const double skin : {0.05, 0.3, 0.6}) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.8}},
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}}, boundary::walls{},
                       half_step_velocity_verlet{1e-7}, run_options{.skin = skin}};
    // Two small grains touch; two large ones are a good way apart, farther than any list of small pairs would see.
    s.add({{0, 0, 0}, 0.5e-3, 2600});
    s.add({{1e-3 - 1e-9, 0, 0}, 0.5e-3, 2600});
    s.add({{0, 20e-3, 0}, 2e-3, 2600});
    s.add({{4.6e-3, 20e-3, 0}, 2e-3, 2600});
    s.distribute_liquid(0.35e-9);  // alpha R^3 = 0.346 mm3 for the large pair: reaches 0.70 mm
    counts.push_back(s.bridges().count());
    CHECK(s.bridges().book().total() == within(1e-15, 0.35e-9));
  }
  CHECK(counts == std::vector<std::size_t>{2, 2, 2});
}

TEST_CASE("every liquid of a scene that is distributed twice is the sum of both") {
  pendular::system s{material{normal::linear{1e3}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                     boundary::walls{}, half_step_velocity_verlet{1e-7}};
  for (int k = 0; k < 4; ++k) s.add({{1e-3 * k, 0, 0}, 0.5e-3, 2600});
  s.distribute_liquid(1e-12);
  s.distribute_liquid(2e-12);
  CHECK(s.bridges().count() == 3);
  for (std::size_t p = 0; p < 3; ++p) CHECK(s.bridges().book().bonds()[p] == within(1e-14, 1e-12));
  CHECK_THROWS_AS(s.distribute_liquid(-1e-12), input_error);
  CHECK_THROWS_AS(s.distribute_liquid(1e-12, {.thinning = 0.5}), input_error);
}
