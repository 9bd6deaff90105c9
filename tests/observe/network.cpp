// SPDX-License-Identifier: BSD-3-Clause
// Fabric, forces and pressures of the network of pairs, against chains and lattices worked out by hand.
#include "../catch.hpp"

#include <pendular/boundary/plane.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/fabric.hpp>
#include <pendular/observe/force_distribution.hpp>
#include <pendular/observe/grain_pressures.hpp>
#include <pendular/observe/probability_density.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

using namespace pendular;
using std::numbers::pi;

namespace {
const double kilogram = 3 / (4 * pi);  // density of a grain of 1 kg and 1 m
constexpr run_options unchecked{.overlap_limit = 0.9, .force = true};
constexpr double pull = 2.28708e-4;         // kappa R of water and grains of 0.5 mm, N
constexpr double bridge_volume = 1.25e-12;  // 0.01 R^3, m3; it opens by exp(-gap / 45 um)
const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, formation::within_rupture_distance{}};

auto empty_dry_system(run_options options = unchecked) {
  return pendular::system{material{normal::linear{100}}, boundary::walls{}, velocity_verlet{1e-3}, options};
}

auto empty_wet_system() {
  return pendular::system{material{normal::linear{1e3}}, water, boundary::walls{}, velocity_verlet{1e-7},
                          run_options{.force = true}};
}

/// Six grains in a row, all joined by bridges: one open, one touching and pulled, three pressed by 0.5, 0.7 and 0.9 mN
/// of elastic force. In the row the ids are 4 1 5 0 3 2.
auto wet_chain() {
  constexpr std::array<double, 5> gap{45e-6, -1e-7, -5e-7, -7e-7, -9e-7};
  std::array<double, 6> place{};
  for (std::size_t k = 0; k < 5; ++k) place[k + 1] = place[k] + 1e-3 + gap[k];
  auto s = empty_wet_system();
  for (const std::size_t k : {3u, 1u, 5u, 4u, 0u, 2u}) s.add({{place[k], 0, 0}, 0.5e-3, 2600});
  s.distribute_liquid(5 * bridge_volume);
  return s;
}

/// n^3 touching wet grains of 1 mm.
auto wet_cube(int n) {
  auto s = empty_wet_system();
  constexpr double edge = 1e-3 * (1 - 1e-12);
  for (int i = 0; i < n * n * n; ++i) {
    s.add({{edge * (i % n), edge * (i / n % n), edge * (i / (n * n))}, 0.5e-3, 2600});
  }
  s.distribute_liquid(bridge_volume * 3 * n * n * (n - 1));
  return s;
}

/// Rubbing grains of three sizes, some pressed and some held by bridges, that have turned and slid a little.
auto rough_heap(double skin) {
  pendular::system s{material{normal::linear{1e3}, friction::coulomb_spring{800, 0.5}}, water, boundary::walls{},
                     velocity_verlet{1e-6}, run_options{.skin = skin, .overlap_limit = 0.9, .force = true}};
  for (int i = 0; i < 125; ++i) {
    const auto shifted = [&](int k, double phase) { return 0.95e-3 * k + 4e-5 * std::sin(7.0 * i + phase); };
    s.add({{shifted(i * 2 % 5, 0), shifted(i / 5 % 5, 1), shifted(i / 25, 2)},
           0.42e-3 + 0.03e-3 * (i % 3),
           2600,
           {0.1 * std::sin(3.0 * i), 0.1 * std::cos(5.0 * i), 0}});
  }
  s.distribute_liquid(250 * bridge_volume);
  s.run(20);
  return s;
}

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

void check_matrix(const Eigen::Matrix3d& a, const Eigen::Matrix3d& expected) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) CHECK(a(i, j) == near(1e-13, expected(i, j)));
  }
}

Eigen::Matrix3d diagonal(double x, double y, double z) { return Eigen::Vector3d(x, y, z).asDiagonal(); }
}  // namespace

TEST_CASE("a pair is tensile if its bridge pulls more than its overlap pushes, across a gap or not") {
  const auto chain = wet_chain();
  const auto z = observe::coordination_of(chain);
  CHECK(z.contacts == within(1e-14, 8.0 / 6));
  CHECK(z.bridges == within(1e-14, 10.0 / 6));
  CHECK(z.open_bridges == within(1e-14, 2.0 / 6));
  CHECK(observe::tensile_coordination(chain) == within(1e-14, 4.0 / 6));
}

TEST_CASE("dry pairs that press or only are listed are not tensile") {
  auto s = empty_dry_system();
  for (const double x : {0.0, 1.9, 4.0}) s.add({{x, 0, 0}, 1, kilogram});
  s.start();
  REQUIRE(s.pairs().size() == 2);
  CHECK(observe::tensile_coordination(s) == 0);
}

TEST_CASE("the fabric of one pair is n (x) n") {
  auto s = empty_dry_system();
  s.add({{0, 0, 0}, 1, kilogram});
  SECTION("along x") {
    s.add({{1.9, 0, 0}, 1, kilogram});
    s.start();
    check_matrix(observe::fabric_tensor(s), diagonal(1, 0, 0));
  }
  SECTION("oblique") {
    s.add({{-0.6 * 1.9, 0, 0.8 * 1.9}, 1, kilogram});
    s.start();
    Eigen::Matrix3d expected = diagonal(0.36, 0, 0.64);
    expected(0, 2) = expected(2, 0) = -0.48;
    check_matrix(observe::fabric_tensor(s), expected);
  }
  SECTION("apart") {
    s.add({{2.1, 0, 0}, 1, kilogram});
    s.start();
    REQUIRE(s.pairs().size() == 1);
    check_matrix(observe::fabric_tensor(s), Eigen::Matrix3d::Zero());
    check_matrix(observe::fabric_tensor(s, observe::links::bridges), Eigen::Matrix3d::Zero());
  }
}

TEST_CASE("open bridges are in the fabric of the bridges alone") {
  auto s = empty_wet_system();
  s.add({{0, 0, 0}, 0.5e-3, 2600});
  s.add({{0.9999e-3, 0, 0}, 0.5e-3, 2600});
  s.add({{0, 1.01e-3, 0}, 0.5e-3, 2600});
  s.add({{0, -1.01e-3, 0}, 0.5e-3, 2600});
  s.start();
  check_matrix(observe::fabric_tensor(s, observe::links::bridges), Eigen::Matrix3d::Zero());
  s.distribute_liquid(3 * bridge_volume);
  check_matrix(observe::fabric_tensor(s), diagonal(1, 0, 0));
  check_matrix(observe::fabric_tensor(s, observe::links::contacts), diagonal(1, 0, 0));
  check_matrix(observe::fabric_tensor(s, observe::links::bridges), diagonal(1.0 / 3, 2.0 / 3, 0));
}

TEST_CASE("the fabric of a simple cubic lattice is a third of the identity, that of any has trace 1") {
  const auto cube = wet_cube(3);
  check_matrix(observe::fabric_tensor(cube), Eigen::Matrix3d::Identity() / 3);
  check_matrix(observe::fabric_tensor(cube, observe::links::bridges), Eigen::Matrix3d::Identity() / 3);
  const auto heap = rough_heap(0.3);
  CHECK(observe::fabric_tensor(heap).trace() == within(1e-13, 1));
  CHECK(observe::fabric_tensor(heap, observe::links::bridges).trace() == within(1e-13, 1));
}

TEST_CASE("forces are split by sign and come in the order of ids") {
  const auto f = observe::force_distribution_of(wet_chain());
  REQUIRE(f.compressive.size() == 3);  // pairs 0-3, 0-5, 2-3
  CHECK(f.compressive[0] == within(1e-4, 7e-4 - pull));
  CHECK(f.compressive[1] == within(1e-4, 5e-4 - pull));
  CHECK(f.compressive[2] == within(1e-4, 9e-4 - pull));
  CHECK(f.mean_compressive == within(1e-4, 7e-4 - pull));
  REQUIRE(f.tensile.size() == 2);  // 1-4, 1-5
  CHECK(f.tensile[0] == within(1e-4, pull * std::exp(-1)));
  CHECK(f.tensile[1] == within(1e-4, pull - 1e-4));
  CHECK(f.mean_tensile == within(1e-4, 0.5 * (pull * (1 + std::exp(-1)) - 1e-4)));
}

TEST_CASE("pairs that only are listed have no force to be counted") {
  auto s = empty_dry_system();
  for (const double x : {0.0, 1.9, 4.0}) s.add({{x, 0, 0}, 1, kilogram});
  s.start();
  REQUIRE(s.pairs().size() == 2);
  const auto f = observe::force_distribution_of(s);
  REQUIRE(f.compressive.size() == 1);
  CHECK(f.compressive[0] == within(1e-12, 10));
  CHECK(f.tensile.empty());
  CHECK(f.mean_tensile == 0);
}

TEST_CASE("a probability density is the share of all values over the width of the bin") {
  const std::vector<double> values{6, 1, 3, 2};
  const auto density = [&](std::vector<double> edges) { return observe::probability_density(values, 3, edges); };
  CHECK(density({0, 0.5, 1, 3}) == std::vector<double>{0.5, 0.5, 0.25});
  CHECK(density({0, 1, 2}) == std::vector<double>{0.5, 0.5});  // a value on the last edge is in
  CHECK(density({0, 1}) == std::vector<double>{0.75});         // and one above it is not, but counts
  CHECK(density({-2, -1, 0}) == std::vector<double>{0, 0});
  const std::vector<double> forces{-4, 2};
  CHECK(observe::probability_density(forces, 2, std::vector<double>{-3, 0, 1}) == std::vector<double>{1 / 6.0, 0.5});
  CHECK(observe::probability_density({}, 0, std::vector<double>{0, 1, 2}) == std::vector<double>{0, 0});
}

TEST_CASE("the density of exponentially distributed forces is the exponential, and integrates to 1") {
  std::vector<double> forces, edges;
  const int count = 20000;
  for (int k = 0; k < count; ++k) forces.push_back(-5e-4 * std::log((k + 0.5) / count));
  for (int k = 0; k <= 120; ++k) edges.push_back(0.1 * k);
  const auto density = observe::probability_density(forces, total(forces) / count, edges);
  CHECK(0.1 * total(density) == within(1e-12, 1));
  for (const std::size_t k : {0u, 10u, 30u}) {
    CHECK(density[k] == within(1e-2, (std::exp(-edges[k]) - std::exp(-edges[k + 1])) / 0.1));
  }
}

TEST_CASE("bins in disorder and a unit that is none are refused") {
  const std::vector<double> values{1, 2};
  const auto density = [&](double unit, std::vector<double> edges) {
    return observe::probability_density(values, unit, edges);
  };
  CHECK_THROWS_AS(density(1, {}), input_error);
  CHECK_THROWS_AS(density(1, {0}), input_error);
  CHECK_THROWS_AS(density(1, {0, 0}), input_error);
  CHECK_THROWS_AS(density(1, {0, 2, 1}), input_error);
  CHECK_THROWS_AS(density(1, {0, std::numeric_limits<double>::infinity()}), input_error);
  CHECK_THROWS_AS(density(0, {0, 1}), input_error);
  CHECK_THROWS_AS(density(std::nan(""), {0, 1}), input_error);
}

TEST_CASE("the pressure of a grain is a third of its forces times lever arms over its volume") {
  auto s = empty_dry_system();
  s.add({{0, 0, 2.8}, 2, kilogram});
  s.add({{0, 0, 0}, 1, kilogram});
  s.add({{0, 9, 0}, 1, kilogram});
  s.start();
  const auto p = observe::grain_pressures(s);  // 20 N, meeting in the middle of an overlap of 0.2 m
  REQUIRE(p.size() == 3);
  CHECK(p[0] == within(1e-12, 20 * 1.9 / (3 * 4.0 / 3 * pi * 8)));
  CHECK(p[1] == within(1e-12, 20 * 0.9 / (3 * 4.0 / 3 * pi)));
  CHECK(p[2] == 0);
  CHECK(observe::grain_pressures(s, 0.6)[1] == within(1e-12, 0.6 * 20 * 0.9 / (3 * 4.0 / 3 * pi)));
  CHECK_THROWS_AS(observe::grain_pressures(s, 0), input_error);
  CHECK_THROWS_AS(observe::grain_pressures(s, 1.01), input_error);
  CHECK_THROWS_AS(observe::grain_pressures(s, std::nan("")), input_error);
}

TEST_CASE("walls press a grain as well, their lever arm ending on the wall") {
  const boundary::walls vice{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                             boundary::wall{boundary::plane{{0, 0, 1.7}, {0, 0, -1}}}};
  pendular::system s{material{normal::linear{100}}, vice, velocity_verlet{1e-3}, unchecked};
  s.add({{0, 0, 0.8}, 1, kilogram});
  s.start();
  CHECK(observe::grain_pressures(s)[0] == within(1e-12, (20 * 0.8 + 10 * 0.9) / (4 * pi)));
}

TEST_CASE("a grain inside a wet simple cubic lattice is under the capillary tension f0 / d^2") {
  const auto p = observe::grain_pressures(wet_cube(3), pi / 6);
  CHECK(p[13] == within(1e-4, -228.7));       // six bridges
  CHECK(p[0] == within(1e-4, -0.5 * 228.7));  // three at a corner
  CHECK(*std::min_element(p.begin(), p.end()) == p[13]);
}

TEST_CASE("pressures of grains, weighed by their volumes, add up to the Love-Weber stress") {
  const auto s = rough_heap(0.3);
  const auto f = observe::force_distribution_of(s);
  REQUIRE((f.compressive.size() > 50 && f.tensile.size() > 50));
  const double fraction = 0.55;
  const auto p = observe::grain_pressures(s, fraction);
  double volume = 0, moment = 0;
  for (std::size_t id = 0; id < p.size(); ++id) {
    const double own = 4.0 / 3 * pi * std::pow(0.42e-3 + 0.03e-3 * static_cast<double>(id % 3), 3) / fraction;
    volume += own;
    moment += own * p[id];
  }
  CHECK(moment == within(1e-12, volume * observe::love_weber_stress(s, volume).trace() / 3));
}

TEST_CASE("no bit of the network depends on the neighbour list or on where grains are stored") {
  const auto a = rough_heap(0.05), b = rough_heap(0.9);
  REQUIRE(a.pairs().size() < b.pairs().size());
  REQUIRE(a.particles().rows_by_id() != b.particles().rows_by_id());
  CHECK(observe::grain_pressures(a) == observe::grain_pressures(b));
  CHECK(observe::fabric_tensor(a) == observe::fabric_tensor(b));
  CHECK(observe::fabric_tensor(a, observe::links::bridges) == observe::fabric_tensor(b, observe::links::bridges));
  const auto f = observe::force_distribution_of(a), g = observe::force_distribution_of(b);
  CHECK((f.compressive == g.compressive && f.tensile == g.tensile));
  CHECK((f.mean_compressive == g.mean_compressive && f.mean_tensile == g.mean_tensile));
}
