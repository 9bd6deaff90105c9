// SPDX-License-Identifier: BSD-3-Clause
// Neighbours that press and that pull, against a chain of six grains worked out by hand.
#include "../catch.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/force_distribution.hpp>
#include <pendular/observe/pair_signs.hpp>
#include <pendular/system.hpp>

#include <array>
#include <cmath>
#include <vector>

using namespace pendular;
using observe::pair_signs;

namespace {
constexpr double bridge_volume = 1.25e-12;  // 0.01 R^3, m3; a bridge that pulls grains of 0.5 mm by 0.23 mN
const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, formation::within_rupture_distance{}};

/// Six grains in a row, all joined by bridges: one open, one touching and pulled, three pressed by more than a bridge
/// pulls. In the row the ids are 4 1 5 0 3 2.
auto wet_chain() {
  constexpr std::array<double, 5> gap{45e-6, -1e-7, -5e-7, -7e-7, -9e-7};
  std::array<double, 6> place{};
  for (std::size_t k = 0; k < 5; ++k) place[k + 1] = place[k] + 1e-3 + gap[k];
  pendular::system s{material{normal::linear{1e3}}, water, boundary::walls{}, velocity_verlet{1e-7},
                     run_options{.force = true}};
  for (const std::size_t k : {3u, 1u, 5u, 4u, 0u, 2u}) s.add({{place[k], 0, 0}, 0.5e-3, 2600});
  s.distribute_liquid(5 * bridge_volume);
  return s;
}

/// (k+, k-): two of (1, 1), one of (2, 0), one of (0, 1).
const std::vector<pair_signs> four{{1, 1}, {2, 0}, {1, 1}, {0, 1}};
}  // namespace

TEST_CASE("every grain knows how many neighbours press it and how many pull it") {
  const auto chain = wet_chain();
  const auto signs = observe::pair_signs_of(chain);
  REQUIRE(signs.size() == 6);
  const std::vector<std::array<int, 2>> expected{{2, 0}, {0, 2}, {1, 0}, {2, 0}, {0, 1}, {1, 1}};  // by id
  int compressive = 0, tensile = 0;
  for (std::size_t id = 0; id < 6; ++id) {
    CAPTURE(id);
    CHECK(signs[id].compressive == expected[id][0]);
    CHECK(signs[id].tensile == expected[id][1]);
    compressive += signs[id].compressive, tensile += signs[id].tensile;
  }
  CHECK(tensile / 6.0 == within(1e-14, observe::tensile_coordination(chain)));
  CHECK(static_cast<std::size_t>(compressive) == 2 * observe::force_distribution_of(chain).compressive.size());
}

TEST_CASE("pairs without force and walls do not count") {
  const boundary::walls floor{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}};
  pendular::system s{material{normal::linear{100}}, floor, velocity_verlet{1e-3},
                     run_options{.overlap_limit = 0.9, .force = true}};
  s.add({{0, 0, 0.9}, 1, 0.2});
  s.add({{2.1, 0, 2}, 1, 0.2});
  s.start();
  for (const pair_signs& k : observe::pair_signs_of(s)) CHECK((k.compressive == 0 && k.tensile == 0));
}

TEST_CASE("the joint distribution is the share of the grains of every class, and adds up to 1") {
  const auto rho = observe::class_shares(four, std::vector<double>(4, 1.0));
  REQUIRE((rho.rows() == 3 && rho.cols() == 3));
  CHECK(rho(1, 1) == 0.5);
  CHECK(rho(2, 0) == 0.25);
  CHECK(rho(0, 1) == 0.25);
  CHECK(rho.sum() == 1);
  CHECK(rho.trace() == 0.5);        // as many of both
  CHECK(rho.row(0).sum() == 0.25);  // nothing presses
}

TEST_CASE("the shares of the classes in a quantity add up to its mean") {
  const auto partial = observe::class_shares(four, std::vector<double>{3, 8, -1, -6});
  CHECK(partial(1, 1) == 0.5);
  CHECK(partial(2, 0) == 2);
  CHECK(partial(0, 1) == -1.5);
  CHECK(partial.sum() == 1);
  CHECK(observe::class_shares({}, {}).size() == 0);
  CHECK_THROWS_AS(observe::class_shares(four, std::vector<double>{1, 2}), input_error);
}

TEST_CASE("grains in a bin of values have mean numbers of neighbours") {
  const std::vector<double> pressure{3, 8, -1, -6};
  const auto bins = observe::signs_by_class(four, pressure, std::vector<double>{-6, -1, 3, 8});
  REQUIRE(bins.size() == 3);
  CHECK((bins[0].grains == 1 && bins[0].compressive == 0 && bins[0].tensile == 1));
  CHECK((bins[1].grains == 1 && bins[1].compressive == 1 && bins[1].tensile == 1));  // an edge counts above
  CHECK((bins[2].grains == 2 && bins[2].compressive == 1.5 && bins[2].tensile == 0.5));
  const auto none = observe::signs_by_class(four, pressure, std::vector<double>{100, 200});
  CHECK((none[0].grains == 0 && none[0].compressive == 0 && none[0].tensile == 0));
  CHECK_THROWS_AS(observe::signs_by_class(four, pressure, std::vector<double>{1}), input_error);
  CHECK_THROWS_AS(observe::signs_by_class(four, std::vector<double>{1}, std::vector<double>{0, 1}), input_error);
}
