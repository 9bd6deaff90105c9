// SPDX-License-Identifier: BSD-3-Clause
// Bad input in one sentence each.
#include "../catch.hpp"
#include "samples.hpp"

#include <limits>

using namespace samples;
using Catch::Matchers::Contains;

TEST_CASE("a bridge that is none is refused with value, bound and page") {
  const liquid_bridge good = bridge(2, 0.3, 1e-3);
  const auto changed = [&](auto change) {
    liquid_bridge b = good;
    change(b);
    return b;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using pendular::input_error;
  for (const double bad : {0.0, -1e-3, nan}) {
    CHECK_THROWS_AS(rupture_distance(changed([&](liquid_bridge& b) { b.radius_i = bad; })), input_error);
    CHECK_THROWS_AS(rupture_distance(changed([&](liquid_bridge& b) { b.radius_j = bad; })), input_error);
    CHECK_THROWS_AS(rupture_distance(changed([&](liquid_bridge& b) { b.volume = bad; })), input_error);
    CHECK_THROWS_AS(rupture_distance(changed([&](liquid_bridge& b) { b.surface_tension = bad; })), input_error);
  }
  for (const double bad : {-0.1, std::numbers::pi / 2, nan}) {
    CHECK_THROWS_AS(rupture_distance(changed([&](liquid_bridge& b) { b.contact_angle = bad; })), input_error);
  }
  CHECK_THROWS_AS(rupture_distance(changed([&](liquid_bridge& b) { b.radius_i = b.radius_j = infinite; })),
                  input_error);
  CHECK_THROWS_AS(solve(good, -1e-9), input_error);
  CHECK_THROWS_AS(solve(good, nan), input_error);
  CHECK_THROWS_AS(profile(good, 0, 1), input_error);
  CHECK_THROWS_AS(solve_at_suction(good, 0, nan), input_error);
  CHECK_THROWS_WITH(solve(good, -1.0), "the gap of a bridge (m) is -1, but must be at least 0 and finite (see "
                                       "docs/reference/laplace_young.md)");
}

TEST_CASE("a volume out of bounds, or that joins no touching bodies, is an error and not a number") {
  CHECK_THROWS_AS(rupture_distance(bridge(1, 0, 1e4)), pendular::input_error);
  CHECK_THROWS_AS(rupture_distance(bridge(1, 0, 1e-20)), pendular::input_error);
  CHECK_THROWS_AS(rupture_distance(bridge(10, 1.56, 9)), pendular::run_error);
  CHECK_THROWS_AS(profile(bridge(10, 1.56, 9), 0), pendular::run_error);
}
