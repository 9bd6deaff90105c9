// SPDX-License-Identifier: BSD-3-Clause
// Where the stable branch ends, by the fold and by the antisymmetric mode, and what lies beyond: nothing.
#include "../catch.hpp"
#include "samples.hpp"

#include <algorithm>

using namespace samples;

namespace {
double reduced_rupture(double ratio, double angle, double volume) {
  return rupture_distance(bridge(ratio, angle, volume)) / radius;
}
constexpr double degree = std::numbers::pi / 180;
}  // namespace

TEST_CASE("rupture distances of an independent solver") {
  CHECK(reduced_rupture(1, 0, 1e-4) == within(1e-3, .0467));
  CHECK(reduced_rupture(1, 0, 1e-3) == within(1e-3, .1008));
  CHECK(reduced_rupture(1, 0, 1e-2) == within(1e-3, .2189));
  CHECK(reduced_rupture(2, 0, 1e-2) == within(1e-3, .2145));
  CHECK(reduced_rupture(infinite, 0, 1e-3) == within(1e-3, .0992));
  CHECK(reduced_rupture(infinite, 0, 1e-2) == within(1e-3, .2075));
  CHECK(reduced_rupture(infinite, 0, 1e-1) == within(1e-3, .4170));
}

TEST_CASE("equal spheres: the closed form that Willett and others fitted to the fold, up to 31 degrees") {
  for (const double angle : {0.0, 10.0, 20.0, 30.0}) {
    for (const double volume : {1e-4, 1e-3, 1e-2, 1e-1}) {
      const double v = std::cbrt(volume), fit = (1 + 0.5 * angle * degree) * (v + 0.1 * v * v);
      CAPTURE(angle, volume);
      CHECK(reduced_rupture(1, angle * degree, volume) == within(0.05, fit));
    }
  }
}

TEST_CASE("at the fold the force falls with the square root of what is left of the gap") {
  for (const double ratio : {1.0, 5.0, infinite}) {
    bridges_of_volume bridges(bridge(ratio, 0.2, 1e-3));
    const double farthest = bridges.rupture_distance(), last = bridges.last().attraction;
    const auto above = [&](double left) { return bridges.at((1 - left) * farthest)->attraction - last; };
    CHECK(last > 0);
    CHECK(above(4e-6) / above(1e-6) == within(0.01, 2));
    CHECK(above(4e-8) / above(1e-8) == within(0.01, 2));
  }
}

TEST_CASE("equal spheres above 31 degrees break earlier than nearly equal ones would tell: a cusp in the ratio") {
  // Without the antisymmetric mode the distance would be a smooth function of the logarithm of the ratio, with a
  // quadratic maximum at 1.
  for (const double angle : {40.0, 60.0}) {
    const double equal = reduced_rupture(1, angle * degree, 1e-2);
    const auto shorter = [&](double excess) { return equal - reduced_rupture(1 + excess, angle * degree, 1e-2); };
    CHECK(shorter(1e-6) > 0);
    CHECK(shorter(8e-6) / shorter(1e-6) == within(0.02, 4));  // (r - 1)^{2/3}
    CHECK(shorter(8e-5) / shorter(1e-5) == within(0.02, 4));
  }
  const double flat = reduced_rupture(1, 0, 1e-2);
  const double near = flat - reduced_rupture(1 + 1e-3, 0, 1e-2), far = flat - reduced_rupture(1 + 4e-3, 0, 1e-2);
  CHECK(far / near == within(0.05, 4));  // smooth: linear in the mean size at this fixed volume
}

TEST_CASE("at 60 degrees equal spheres break by the antisymmetric mode, before their force falls steeply") {
  const auto steepness = [](double angle) {
    bridges_of_volume bridges(bridge(1, angle * degree, 1e-2));
    const double farthest = bridges.rupture_distance(), step = 1e-7 * farthest;
    const double slope = (bridges.at(farthest - 2 * step)->attraction - bridges.at(farthest - step)->attraction) / step;
    return slope * farthest / bridges.last().attraction;
  };
  CHECK(steepness(20) > 300);  // a fold: without bound
  CHECK(steepness(60) < 10);   // an ordinary point of the symmetric branch
}

TEST_CASE("radii that differ by round-off are equal") {
  for (const double angle : {20.0, 40.0, 67.152}) {
    const double equal = reduced_rupture(1, angle * degree, 7.93e-3);
    for (const double excess : {3e-15, 1e-12, 1e-10}) {
      CHECK(reduced_rupture(1 + excess, angle * degree, 7.93e-3) == within(1e-9, equal));
    }
  }
}

TEST_CASE("just below the end there is a state, just above it none") {
  for (const liquid_bridge& b : of_all_kinds(150, 6)) {
    bridges_of_volume bridges(b);
    const double farthest = bridges.rupture_distance();
    CHECK(farthest > 0);
    CHECK(bridges.at(farthest));
    CHECK(bridges.at(std::nextafter(farthest, 0)));
    CHECK_FALSE(bridges.at(farthest * (1 + 1e-12)));
    CHECK_FALSE(solve(b, 1.5 * farthest));
    CHECK(bridges.last().gap == within(1e-12, farthest));
  }
}

TEST_CASE("more liquid and a larger contact angle reach farther, to 40 degrees") {
  for (const double ratio : {1.0, 2.0, 20.0, infinite}) {
    double last = 0;
    for (const double volume : {1e-8, 1e-6, 1e-4, 1e-2, 1.0}) {
      const double now = reduced_rupture(ratio, 0.3, volume);
      CHECK(now > last);
      last = now;
    }
    last = 0;
    for (const double angle : {0.0, 10.0, 20.0, 30.0, 40.0}) {
      const double now = reduced_rupture(ratio, angle * degree, 1e-3);
      CHECK(now > last);
      last = now;
    }
  }
}

TEST_CASE("asking for many gaps in any order gives the same states as asking for one") {
  const liquid_bridge b = bridge(1.7, 0.6, 3e-3);
  bridges_of_volume bridges(b);
  const double farthest = bridges.rupture_distance();
  for (const double part : {0.9, 0.1, 0.999, 0.5, 0.0, 0.3}) {
    CHECK(bridges.at(part * farthest)->attraction == within(1e-10, solve(b, part * farthest)->attraction));
  }
}
