// SPDX-License-Identifier: BSD-3-Clause
// The viscous force of a bridge against the formulas worked out once more, and its limits.
#include "../catch.hpp"

#include <pendular/law/viscous/lubrication.hpp>
#include <pendular/testing/law_kits.hpp>

#include <limits>

using namespace pendular;

namespace {
constexpr fluid glycerol{0.063, 0, 1260, 1.41};
constexpr double radius = 1e-3, pi = std::numbers::pi;
constexpr viscous::lubrication law{1e-3};

bridge_resistance<double> resistance(double gap, double volume, double other = radius) {
  return law.resistance(bridge<double>{gap, volume, radius, other}, glycerol);
}
}  // namespace

TEST_CASE("two immersed spheres resist as Adams and Perchard have it") {
  // (3/2) pi eta R^2 / D for equal spheres; a bridge of a litre is as good as all around
  for (const double gap : {1e-6, 1e-5, 1e-4}) {
    CHECK(resistance(gap, 1e-3).normal == within(2e-3, 1.5 * pi * 1.41 * radius * radius / gap));
  }
  CHECK(resistance(1e-5, 1e-3, 3 * radius).normal == within(1e-3, 6 * pi * 1.41 * std::pow(0.75 * radius, 2) / 1e-5));
}

TEST_CASE("a finite bridge resists less, by the square of its filling") {
  // V = 1e-11, R_h = 1e-3, D = 5e-5: 2 V / (pi R_h D^2) = 2.546479; 1 - 1/sqrt(3.546479) = 0.468992, squared 0.219954
  CHECK(resistance(5e-5, 1e-11).normal == within(1e-5, 0.219954 * 1.5 * pi * 1.41 * radius * radius / 5e-5));
  CHECK(resistance(5e-5, 0).normal == 0);
  CHECK(resistance(5e-5, 0).tangential == 0);
  double last = 0;
  for (const double volume : {1e-15, 1e-13, 1e-11, 1e-9}) {
    CHECK(resistance(5e-5, volume).normal > last);
    last = resistance(5e-5, volume).normal;
  }
}

TEST_CASE("sliding resists as Goldman, Cox and Brenner have it, and never pushes along") {
  // R* = 5e-4, D = 5e-6: (8/15) ln 100 + 0.9588 = 3.414891
  CHECK(resistance(5e-6, 1e-11).tangential == within(1e-6, 6 * pi * 1.41 * 5e-4 * 3.414891));
  CHECK(resistance(5e-3, 1e-11).tangential == 0);
}

TEST_CASE("the film is never thinner than the least gap, from both sides of contact") {
  const auto least = resistance(1e-3 * 5e-4, 1e-11);
  for (const double gap : {4e-7, 1e-9, 0.0, -1e-9, -1e-5}) {
    CHECK(resistance(gap, 1e-11).normal == least.normal);
    CHECK(resistance(gap, 1e-11).tangential == least.tangential);
  }
}

TEST_CASE("it scales, does not care who is i, knows a wall and every scalar") {
  const auto one = resistance(1e-5, 1e-11, 2e-3);
  const auto large = law.resistance(bridge<double>{1e-4, 1e-8, 1e-2, 2e-2}, glycerol);
  const auto turned = law.resistance(bridge<double>{1e-5, 1e-11, 2e-3, radius}, glycerol);
  CHECK(large.normal == within(1e-12, 10 * one.normal));
  CHECK(large.tangential == within(1e-12, 10 * one.tangential));
  CHECK((turned.normal == within(1e-14, one.normal) && turned.tangential == within(1e-14, one.tangential)));
  const auto wall = resistance(1e-5, 1e-3, std::numeric_limits<double>::infinity());
  CHECK(wall.normal == within(1e-3, 6 * pi * 1.41 * radius * radius / 1e-5));
  const auto same_in = [&]<class T>(T) {
    const auto r = law.resistance(bridge<T>{T(1e-5), T(1e-11), T(radius), T(2e-3)}, glycerol);
    CHECK(testing::number(T(r.normal)) == within(1e-5, one.normal));
    CHECK(testing::number(T(r.tangential)) == within(1e-5, one.tangential));
  };
  same_in(0.0f);
  same_in(dual(0.0));
  same_in(lanes<8>(0.0));
  same_in(lanes<16, float>(0.0f));
}

TEST_CASE("a least gap out of (0, 1) is refused") {
  for (const double bad : {0.0, -1.0, 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(validate(viscous::lubrication{bad}), input_error);
  }
}
