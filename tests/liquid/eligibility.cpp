// SPDX-License-Identifier: BSD-3-Clause
// Eq. 14 with its implicit eligibility, against hand-made cases and against a search through all sets of pairs.
#include "../catch.hpp"
#include "hand_made.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

using namespace pendular;

namespace {
constexpr fluid water = fluid::water();
constexpr rupture::lian lian{};

/// Candidate of two grains of radius 1 (R^3 = 1): it joins at alpha = gap^3.
candidate of_gap(double gap, std::int64_t id = 0) { return {0, {gap, 0, 1, 1}, {id, id + 1000}}; }

std::vector<std::size_t> sorted(std::vector<std::size_t> rows) {
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// The largest set of candidates all of which hold a bridge of alpha = volume / sum R^3 and that leaves out nobody who
/// could join at less: found by trying all sets.
struct best_set {
  double alpha = 0;
  unsigned members = 0;
};
best_set by_all_sets(const std::vector<candidate>& all, double volume) {
  const auto cube_of_gap = [](const candidate& c) { return std::pow(std::max(c.geometry.gap, 0.0), 3) / c.size(); };
  best_set best;
  int most = 0;
  for (unsigned set = 1; set < (1u << all.size()); ++set) {
    double sizes = 0, hardest_in = 0, easiest_out = HUGE_VAL;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool in = set >> k & 1;
      sizes += in ? all[k].size() : 0;
      if (in) hardest_in = std::max(hardest_in, cube_of_gap(all[k]));
      if (!in) easiest_out = std::min(easiest_out, cube_of_gap(all[k]));
    }
    const double alpha = volume / sizes;
    const int count = __builtin_popcount(set);
    if (alpha >= hardest_in && hardest_in <= easiest_out && count > most) most = count, best = {alpha, set};
  }
  return best;
}
}  // namespace

TEST_CASE("the joining alpha of a pair is the one at which its bridge just reaches across") {
  CHECK(joining_alpha(lian, water, of_gap(-0.1)) == 0);
  CHECK(joining_alpha(lian, water, of_gap(0)) == 0);
  CHECK(joining_alpha(lian, water, of_gap(0.1)) == within(1e-12, 1e-3));
  CHECK(joining_alpha(lian, water, of_gap(1e-5)) == within(1e-12, 1e-15));
  CHECK(std::isinf(joining_alpha(lian, water, of_gap(0.8))));  // 0.512 is above widest_bridge
  // radii 1 and 4: R^3 = 8, so a gap of 0.2 needs 0.008 m3
  CHECK(joining_alpha(lian, water, candidate{0, {0.2, 0, 1, 4}, {0, 1}}) == within(1e-12, 1e-3));
}

TEST_CASE("the joining alpha is eligible itself: the tie goes to the bridge") {
  const candidate c = of_gap(0.1234567);
  const double alpha = joining_alpha(lian, water, c);
  CHECK(lian.distance(bridge<double>{0, alpha, 1, 1}, water) >= 0.1234567);
  CHECK(lian.distance(bridge<double>{0, std::nextafter(alpha, 0.0), 1, 1}, water) < 0.1234567);
}

TEST_CASE("the sorted prefix settles where the plain iteration swings between two sets for ever") {
  // One touching pair and one at a gap of 0.1 (joins at 1e-3), with 1.5e-3: alone alpha = 1.5e-3 lets the second in,
  // together alpha = 0.75e-3 throws it out again.
  const std::vector<candidate> pairs{of_gap(0, 1), of_gap(0.1, 2)};
  const auto one_round = [&](bool second_in) { return 1.5e-3 / (second_in ? 2 : 1) >= 1e-3; };
  CHECK((one_round(false) && !one_round(true)));
  const homogeneous_share s = share_homogeneously(lian, water, pairs, 1.5e-3);
  CHECK(s.eligible == std::vector<std::size_t>{0});
  CHECK(s.alpha == 1.5e-3);
  const homogeneous_share both = share_homogeneously(lian, water, pairs, 2.001e-3);
  CHECK(sorted(both.eligible) == std::vector<std::size_t>{0, 1});
  CHECK(both.alpha == within(1e-15, 1.0005e-3));
}

TEST_CASE("large pairs get more liquid, in proportion to R cubed") {
  const std::vector<candidate> pairs{{0, {0, 0, 1, 1}, {0, 1}}, {1, {0, 0, 1, 4}, {0, 2}}, {2, {0, 0, 4, 4}, {1, 2}}};
  const homogeneous_share s = share_homogeneously(lian, water, pairs, 1.0);
  CHECK(s.alpha == within(1e-14, 1.0 / 73));  // 1 + 8 + 64
  CHECK(s.eligible.size() == 3);
}

TEST_CASE("touching pairs share alone if the liquid reaches nobody else") {
  const homogeneous_share s =
      share_homogeneously(lian, water, {of_gap(-1e-3, 1), of_gap(0.5, 2), of_gap(0, 3), of_gap(0.2, 4)}, 1e-4);
  CHECK(sorted(s.eligible) == std::vector<std::size_t>{0, 2});
  CHECK(s.alpha == within(1e-15, 5e-5));
}

TEST_CASE("without a pair in reach or without a pair nothing is shared") {
  CHECK(share_homogeneously(lian, water, {}, 1.0).eligible.empty());
  CHECK(share_homogeneously(lian, water, {}, 1.0).alpha == 0);
  const homogeneous_share s = share_homogeneously(lian, water, {of_gap(0.5), of_gap(0.9)}, 1e-3);
  CHECK((s.eligible.empty() && s.alpha == 0));
}

TEST_CASE("no liquid makes no volume") {
  CHECK(share_homogeneously(lian, water, {of_gap(0), of_gap(0.1)}, 0).alpha == 0);
}

TEST_CASE("of two pairs at the same gap that cannot both be served the lower ids are") {
  // Together 0.6e-3 each, which does not reach across 0.1; one alone gets 1.2e-3, which does.
  for (const auto& pairs : {std::vector{of_gap(0.1, 5), of_gap(0.1, 2)}, std::vector{of_gap(0.1, 2), of_gap(0.1, 5)}}) {
    const homogeneous_share s = share_homogeneously(lian, water, pairs, 1.2e-3);
    REQUIRE(s.eligible.size() == 1);
    CHECK(pairs[s.eligible[0]].ids.first == 2);
  }
}

TEST_CASE("random pairs get what a search through all sets finds, in any order") {
  boost::random::mt19937_64 random(11);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  int with_gaps = 0, without_all = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<candidate> all;
    for (std::int64_t k = 0; k < 9; ++k) {
      const double gap = k < 2 ? -0.01 : 0.3 * unit(random);
      all.push_back({0, {gap, 0, 0.5 + unit(random), 0.5 + unit(random)}, {k, k + 100}});
    }
    const double volume = std::pow(10, -3 + 2.5 * unit(random));
    const homogeneous_share s = share_homogeneously(lian, water, all, volume);
    const best_set best = by_all_sets(all, volume);
    unsigned members = 0;
    for (const std::size_t k : s.eligible) members |= 1u << k;
    REQUIRE(members == best.members);
    CHECK(s.alpha == within(1e-13, best.alpha));
    with_gaps += s.eligible.size() > 2 ? 1 : 0;
    without_all += s.eligible.size() < 9 ? 1 : 0;

    std::vector<candidate> mixed = all;
    for (std::size_t k = mixed.size(); k > 1; --k) {
      std::swap(mixed[k - 1], mixed[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(random)]);
    }
    const homogeneous_share again = share_homogeneously(lian, water, mixed, volume);
    CHECK(again.alpha == s.alpha);
    REQUIRE(again.eligible.size() == s.eligible.size());
    for (std::size_t k = 0; k < s.eligible.size(); ++k) {
      CHECK(mixed[again.eligible[k]].ids == all[s.eligible[k]].ids);
    }
  }
  CHECK((with_gaps > 100 && without_all > 100));
}

TEST_CASE("pairs out of reach that the list happens to hold do not change the share, to the last bit") {
  boost::random::mt19937_64 random(12);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<candidate> all;
    for (std::int64_t k = 0; k < 200; ++k) {
      all.push_back({0, {0.15 * unit(random) - 0.05, 0, 0.5 + unit(random), 0.5 + unit(random)}, {k, k + 1000}});
    }
    const double alpha = share_homogeneously(lian, water, all, 0.5).alpha;
    for (std::int64_t k = 200; k < 1000; ++k) all.push_back(of_gap(3 + unit(random), k));
    CHECK(share_homogeneously(lian, water, all, 0.5).alpha == alpha);
  }
}

TEST_CASE("more liquid takes no pair away, and a pair that joins thins the bridges but never breaks one") {
  std::vector<candidate> all;
  for (int k = 0; k < 40; ++k) all.push_back(of_gap(0.01 * (k - 2), k));
  homogeneous_share last;
  for (double volume = 1e-5; volume < 1; volume *= 1.1) {
    const homogeneous_share s = share_homogeneously(lian, water, all, volume);
    CHECK(s.eligible.size() >= last.eligible.size());
    CHECK((s.alpha >= last.alpha || s.eligible.size() > last.eligible.size()));
    CHECK(s.alpha >= std::pow(all[s.eligible.back()].geometry.gap, 3) * (1 - 1e-12));
    last = s;
  }
  CHECK(last.eligible.size() > 20);
}
