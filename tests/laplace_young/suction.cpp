// SPDX-License-Identifier: BSD-3-Clause
// Bridges at a suction held fixed, against those at fixed volume.
#include "../catch.hpp"
#include "samples.hpp"

#include <algorithm>
#include <functional>
#include <vector>

using namespace samples;

TEST_CASE("where a bridge is stable at its suction, both ways of asking give the same one") {
  for (const double ratio : {1.0, 2.0, 30.0, infinite}) {
    for (const double angle : {0.0, 0.5}) {
      for (const double volume : {1e-6, 1e-4, 1e-2, 1.0}) {
        const liquid_bridge b = bridge(ratio, angle, volume);
        bridges_of_volume bridges(b);
        for (const double part : {0.0, 1e-3, 1e-2}) {
          const double gap = part * bridges.rupture_distance();
          const state s = *bridges.at(gap);
          const auto same = solve_at_suction(b, gap, s.suction);
          CAPTURE(ratio, angle, volume, part);
          REQUIRE(same);
          CHECK(same->volume == within(1e-7, s.volume));
          CHECK(same->attraction == within(1e-7, s.attraction));
          CHECK(same->suction == within(1e-9, s.suction));
        }
      }
    }
  }
}

TEST_CASE("at fixed suction a bridge takes a little liquid, loses it and breaks short of two plates' meniscus") {
  const double suction = 20 * tension / radius;
  std::vector<double> volumes;
  for (double gap = 0; gap < 0.2 * radius; gap += 0.002 * radius) {
    const auto s = solve_at_suction(bridge(1, 0, 1), gap, suction);
    if (!s) break;
    CHECK(s->suction == within(1e-9, suction));
    volumes.push_back(s->volume);
  }
  const double end = 0.002 * radius * static_cast<double>(volumes.size());
  CHECK(end > 0.5 * 2 * tension / suction);
  CHECK(end < 2 * tension / suction);  // what a meniscus spans between parallel plates
  const auto top = std::max_element(volumes.begin(), volumes.end());
  CHECK(top != volumes.begin());
  CHECK(std::is_sorted(volumes.begin(), top + 1));
  CHECK(std::is_sorted(top, volumes.end(), std::greater<>()));
  CHECK(volumes.back() < 0.5 * *top);
}

TEST_CASE("of the two bridges that have a suction at a gap it is that with more liquid") {
  const double suction = 10 * tension / radius, gap = 0.05 * radius, cube = radius * radius * radius;
  const auto s = solve_at_suction(bridge(1, 0, 1), gap, suction);
  REQUIRE(s);
  CHECK(s->volume > 0.01 * cube);
  CHECK(solve(bridge(1, 0, s->volume / cube), gap)->suction == within(1e-6, suction));
  // the other one, by halving
  double low = 1e-4 * cube, high = 2e-4 * cube;
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    (solve(bridge(1, 0, middle / cube), gap)->suction < suction ? low : high) = middle;
  }
  CHECK(solve(bridge(1, 0, low / cube), gap)->suction == within(1e-6, suction));
  CHECK(low < 0.01 * s->volume);
}

TEST_CASE("a liquid above the pressure of the gas is found too, on the side of less liquid") {
  // k falls to -6.48/R at V = 4.6e-3 R^3 and rises again
  const double angle = 80 * std::numbers::pi / 180;
  for (const double volume : {5e-4, 2e-3, 3e-3, 4e-3}) {
    const liquid_bridge b = bridge(1, angle, volume);
    const state s = *solve(b, 0);
    CHECK(s.suction < 0);
    const auto same = solve_at_suction(b, 0, s.suction);
    REQUIRE(same);
    CHECK(same->volume == within(1e-6, s.volume));
  }
}

TEST_CASE("more suction holds less liquid between touching bodies") {
  for (const double ratio : {1.0, 4.0, infinite}) {
    double last = 1;
    for (const double suction : {10.0, 1e2, 1e3, 1e4, 1e5}) {
      const auto s = solve_at_suction(bridge(ratio, 0.2, 1), 0, suction);
      if (suction < 100 && !s) continue;
      REQUIRE(s);
      CHECK(s->volume < last);
      last = s->volume;
    }
  }
  CHECK_FALSE(solve_at_suction(bridge(1, 0.2, 1), 0, -1e6));
}
