// SPDX-License-Identifier: BSD-3-Clause
// Where bridges form, and between whom.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <pendular/liquid/formation.hpp>
#include <pendular/liquid/selection.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

using namespace pendular;

TEST_CASE("bridges form at touch, or as far as they would live") {
  CHECK(formation::at_contact{}.reach(0.3) == 0);
  CHECK(formation::within_rupture_distance{}.reach(0.3) == 0.3);
  CHECK(formation::at_contact{}.minimum_volume == 1e-6);
  CHECK(formation::within_rupture_distance{1e-4}.minimum_volume == 1e-4);
}

TEST_CASE("a selection without thinning keeps every pair") {
  for (std::int64_t i = 0; i < 50; ++i) CHECK(bond_selection{}.keeps(i, i + 1));
}

TEST_CASE("thinning by two keeps half of the pairs, by five a fifth, whatever the seed") {
  for (const std::uint64_t seed : {0u, 1u, 12345u}) {
    for (const double thinning : {2.0, 5.0, 1.25}) {
      int kept = 0, pairs = 0;
      for (std::int64_t i = 0; i < 300; ++i) {
        for (std::int64_t j = i + 1; j < 300; ++j, ++pairs) kept += bond_selection{thinning, seed}.keeps(i, j) ? 1 : 0;
      }
      // Four standard deviations of a binomial draw of 44850.
      const double share = 1 / thinning, spread = 4 * std::sqrt(share * (1 - share) / pairs);
      CHECK(static_cast<double>(kept) / pairs == near(spread, share));
    }
  }
}

TEST_CASE("a selection depends on the two grains and the seed, and not on who is asked first") {
  const bond_selection half{2, 3}, other{2, 4};
  int different = 0, same_as_shifted = 0;
  for (std::int64_t i = 0; i < 60; ++i) {
    for (std::int64_t j = i + 1; j < 60; ++j) {
      CHECK(half.keeps(i, j) == half.keeps(j, i));
      CHECK(half.keeps(i, j) == bond_selection{2, 3}.keeps(i, j));
      different += half.keeps(i, j) != other.keeps(i, j) ? 1 : 0;
      same_as_shifted += half.keeps(i, j) == half.keeps(i + 1, j + 1) ? 1 : 0;
    }
  }
  CHECK((different > 700 && different < 1070));              // of 1770
  CHECK((same_as_shifted > 700 && same_as_shifted < 1070));  // no stripes
}

TEST_CASE("every grain loses about half of its bonds, none all of them") {
  const bond_selection half{2, 1};
  for (std::int64_t i = 0; i < 100; ++i) {
    int kept = 0;
    for (std::int64_t j = 0; j < 100; ++j) kept += j != i && half.keeps(i, j) ? 1 : 0;
    CHECK((kept > 25 && kept < 75));
  }
}

TEST_CASE("a stronger thinning keeps a part of what a weaker one keeps") {
  for (std::int64_t i = 0; i < 1000; ++i) {
    if (bond_selection{4, 9}.keeps(i, i + 7)) CHECK(bond_selection{2, 9}.keeps(i, i + 7));
  }
}

TEST_CASE("thinnings without meaning are refused") {
  CHECK_NOTHROW(validate(bond_selection{1}));
  CHECK_NOTHROW(validate(bond_selection{2.5}));
  for (const double bad : {0.5, 0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(validate(bond_selection{bad}), input_error);
  }
}

TEST_CASE("without a rule bridges form within reach under the homogeneous protocol and at contact otherwise") {
  using hand_made::wet;
  const rupture::lian lian{};
  CHECK(wet(lian).formation().reach(0.3) == 0);
  CHECK(wet(lian, protocol::none{}).formation().reach(0.3) == 0);
  CHECK(wet(lian, protocol::neighbours{}).formation().reach(0.3) == 0);
  CHECK(wet(protocol::grain_films{}, lian).formation().reach(0.3) == 0);
  CHECK(wet(lian, protocol::gravity{}).formation().reach(0.3) == 0);
  CHECK(wet(lian, protocol::homogeneous{}).formation().reach(0.3) == 0.3);
}

TEST_CASE("a rule that is given wins over the default, with its own numbers") {
  using hand_made::wet;
  const auto contact = wet(rupture::lian{}, formation::at_contact{1e-3}, protocol::homogeneous{});
  CHECK((contact.formation().reach(0.3) == 0 && contact.formation().minimum_volume == 1e-3));
  const auto within_reach = wet(protocol::gravity{}, formation::within_rupture_distance{2e-3}, rupture::lian{});
  CHECK((within_reach.formation().reach(0.3) == 0.3 && within_reach.formation().minimum_volume == 2e-3));
  CHECK(wet(rupture::lian{}, protocol::homogeneous{250}).redistribution().period == 250);
}

TEST_CASE("a liquid hands fluid and laws to whoever asks") {
  const fluid oil{0.03, 0.5, 900, 0.1};
  const liquid l{rupture::lian{}, capillary::richefeu{1.2}, oil};
  CHECK((l.substance().surface_tension == 0.03 && l.law().decay_constant == 1.2));
  CHECK(l.rupture_distance({0, 1e-9, 1, 1}) == within(1e-14, 1.25e-3));  // the oil's angle is in it
  CHECK_THROWS_AS((liquid{fluid{-1, 0, 1, 0}, capillary::richefeu{}, rupture::lian{}}), input_error);
  CHECK_THROWS_AS((liquid{fluid::water(), capillary::richefeu{-1}, rupture::lian{}}), input_error);
}

TEST_CASE("a period or a minimum volume without meaning is refused") {
  using hand_made::wet;
  const rupture::lian lian{};
  for (const std::int64_t bad : {0, -1}) CHECK_THROWS_AS(wet(lian, protocol::homogeneous{bad}), input_error);
  for (const double bad : {-1e-9, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(wet(lian, formation::at_contact{bad}), input_error);
    CHECK_THROWS_AS(wet(lian, formation::within_rupture_distance{bad}), input_error);
  }
  CHECK_NOTHROW(wet(lian, formation::at_contact{0}, protocol::homogeneous{1}));
}

TEST_CASE("bridges made beyond what their laws say they are valid for are counted") {
  using namespace hand_made;
  packing c;
  c.radius = {1, 1, 5};
  c.pairs = {{0, 1}, {1, 2}};
  c.listed();
  auto b = bonds_of(wet(rupture::lian{}, protocol::grain_films{}), c, {}, {});
  const auto pour = [&](std::size_t pair, double volume) {
    b.introduce(volume);
    b.move(ledger::reservoir(), ledger::bond_of(pair), volume, pair, 0.0, c.view());
    b.made(pair, c.view());
  };
  pour(0, 1e-3);
  CHECK((b.outside().capillary_law == 0 && b.outside().rupture_law == 0));
  pour(0, 0.2);  // beyond 0.1 R^3: rupture::lian
  CHECK((b.outside().capillary_law == 0 && b.outside().rupture_law == 1));
  pour(1, 1e-2);  // a size ratio of 5: both
  CHECK((b.outside().capillary_law == 1 && b.outside().rupture_law == 2));
  // A bridge that breaks and forms again passes through less liquid than it ever has: that is not counted.
  packing two;
  two.radius = {1, 1};
  two.pairs = {{0, 1}};
  two.listed();
  auto small = bonds_of(wet(rupture::lian{}, protocol::grain_films{}), two, {}, {0.8e-6, 0.7e-6});
  two.settle(small, {-1e-3});
  two.settle(small, {0.5}, {-1e-3});
  two.settle(small, {-1e-3}, {0.5});
  CHECK(small.is_bonded(0));
  CHECK(small.outside().rupture_law == 0);
}
