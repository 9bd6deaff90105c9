// SPDX-License-Identifier: BSD-3-Clause

// Capillary stress of lattices of touching wet spheres (physics 2.2 and 4.7 L): exact values f_0/d^2 for the simple
// cubic and 2 sqrt 2 f_0/d^2 for the face-centred cubic one, from bond counting.
#include "scenes.hpp"

#include <pendular/observe/coordination.hpp>
#include <pendular/observe/stress.hpp>

#include <array>

using namespace pendular;
using namespace scenes;

namespace {

constexpr double diameter = 1e-3, radius = 0.5 * diameter;
constexpr double pull = 2.28708e-4;  // kappa R, physics 4.7 H

/// n^3 cubic cells of edge a with the given sites, and the wet scene of them, all bonds at V_b = 0.01 R^3.
template <class Sites>
auto wet_lattice(const Sites& sites, double a, int n, double bonds) {
  pendular::system s{material{normal::linear{1e3}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                     boundary::walls{}, velocity_verlet{1e-7}, run_options{.force = true}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const vector corner{a * i, a * j, a * k};
        for (const vector& site : sites) s.add({corner + a * site, radius, 2600});
      }
    }
  }
  s.start();
  s.distribute_liquid(0.01 * radius * radius * radius * bonds);
  return s;
}

void check_isotropic(const Eigen::Matrix3d& stress, double expected) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == j) {
        CHECK(stress(i, j) == within(1e-4, -expected));  // compression positive
      } else {
        CHECK(std::abs(stress(i, j)) < 1e-8 * expected);
      }
    }
  }
}

/// A spring of k = 1e3 N/m closes touching lattices whose centres round to a gap of some 1e-19 m.
constexpr double nearly_one = 1 - 1e-12;

}  // namespace

TEST_CASE("a simple cubic lattice of wet spheres has the capillary stress f0 / d^2") {
  const int n = 6;
  const int bonds = 3 * n * n * (n - 1);
  auto s = wet_lattice(std::array<vector, 1>{{{0, 0, 0}}}, diameter * nearly_one, n, bonds);
  REQUIRE(s.bridges().count() == static_cast<std::size_t>(bonds));
  // n layers have n - 1 bonds along a line: the volume that belongs to the bonds is n^2 (n - 1) cells.
  const Eigen::Matrix3d stress = observe::love_weber_stress(s, n * n * (n - 1) * std::pow(diameter, 3));
  check_isotropic(stress, 228.7);
  check_isotropic(stress, pull / (diameter * diameter));
  CHECK(observe::coordination_of(s).bridges == within(1e-12, 2.0 * bonds / (n * n * n)));
}

TEST_CASE("a face-centred cubic lattice of wet spheres has the capillary stress 2 sqrt 2 f0 / d^2") {
  const int n = 4;
  const double edge = diameter * std::numbers::sqrt2 * nearly_one;
  const std::array<vector, 4> sites{{{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};
  // On planes of spacing a/2 the block is the checkerboard of even sites of a (2n)^3 grid. Along each of the 6 face
  // diagonals two of three grid coordinates change: 2n (2n - 1)^2 / 2 bonds.
  const int m = 2 * n, bonds = 6 * m * (m - 1) * (m - 1) / 2;
  auto s = wet_lattice(sites, edge, n, bonds);
  REQUIRE(s.particles().size() == static_cast<std::size_t>(4 * n * n * n));
  REQUIRE(s.bridges().count() == static_cast<std::size_t>(bonds));
  // An infinite lattice has 4 grains and 24 bonds in a cell a^3: `bonds` bonds belong to bonds / 24 cells.
  const Eigen::Matrix3d stress = observe::love_weber_stress(s, bonds / 24.0 * std::pow(edge, 3));
  check_isotropic(stress, 646.9);
  check_isotropic(stress, 2 * std::numbers::sqrt2 * pull / (diameter * diameter));
}

TEST_CASE("the net force on every inner grain of a lattice vanishes and on a corner grain it points inwards") {
  const int n = 5;
  auto s = wet_lattice(std::array<vector, 1>{{{0, 0, 0}}}, diameter * nearly_one, n, 3 * n * n * (n - 1));
  const auto force = s.particles().get<column::force>();
  const auto id = s.particles().get<column::id>();
  int inner = 0;
  for (std::size_t row = 0; row < force.size(); ++row) {
    const auto where = id[row];
    const auto i = where / (n * n), j = where / n % n, k = where % n;
    if (i > 0 && j > 0 && k > 0 && i < n - 1 && j < n - 1 && k < n - 1) {
      CHECK(norm(force[row]) < 1e-10 * pull);
      ++inner;
    }
    if (where == 0) CHECK(norm(force[row] - vector{pull, pull, pull}) < 1e-5 * pull);
  }
  CHECK(inner == 27);
}
