// SPDX-License-Identifier: BSD-3-Clause
// Stress, coordination and energies of pairs small enough to be worked out by hand.
#include "../catch.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numbers>

using namespace pendular;

namespace {
const double kilogram = 3 / (4 * std::numbers::pi);  // density of a grain of 1 kg and 1 m
constexpr run_options unchecked{.overlap_limit = 0.9, .force = true};
}  // namespace

TEST_CASE("the stress of a pressed pair is force times branch over volume, compression positive") {
  pendular::system s{material{normal::linear{100}}, boundary::walls{}, velocity_verlet{1e-3}, unchecked};
  s.add({{0, 0, 0}, 1, kilogram});
  s.add({{0.6 * 1.9, 0, 0.8 * 1.9}, 1, kilogram});
  s.start();
  const Eigen::Matrix3d stress = observe::love_weber_stress(s, 38);  // 10 N over a branch of 1.9 m: 0.5 Pa along it
  CHECK(stress(0, 0) == within(1e-12, 0.18));
  CHECK(stress(2, 2) == within(1e-12, 0.32));
  CHECK(stress(0, 2) == within(1e-12, 0.24));
  CHECK(stress(2, 0) == within(1e-12, 0.24));
  CHECK(stress(1, 1) == 0);
}

TEST_CASE("a bridge across a gap pulls: its stress is negative") {
  pendular::system s{
      material{normal::linear{1e3}},
      liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, formation::within_rupture_distance{}},
      boundary::walls{}, velocity_verlet{1e-7}};
  s.add({{0, 0, 0}, 0.5e-3, 2600});
  s.add({{0, 1.045e-3, 0}, 0.5e-3, 2600});
  s.distribute_liquid(1.25e-12);
  // f = 2.28708e-4 N / e at a gap of 45 um
  CHECK(observe::love_weber_stress(s, 1e-9)(1, 1) == within(1e-4, -2.28708e-4 * std::exp(-1) * 1.045e-3 / 1e-9));
  const auto z = observe::coordination_of(s);
  CHECK((z.contacts == 0 && z.bridges == 1 && z.open_bridges == 1));
  CHECK(observe::tensile_coordination(s) == 1);
  CHECK(s.bridges().count() == 1);
}

TEST_CASE("coordination counts every pair for both of its grains") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-7}};
  for (int k = 0; k < 4; ++k) s.add({{0.9999e-3 * k, 0, 0}, 0.5e-3, 2600});
  s.add({{10e-3, 0, 0}, 0.5e-3, 2600});
  s.start();
  const auto z = observe::coordination_of(s);
  CHECK(z.contacts == within(1e-14, 6.0 / 5));
  CHECK((z.bridges == 0 && z.open_bridges == 0));
}

TEST_CASE("the unbalanced force is the mean on a grain over the mean of the pairs") {
  pendular::system s{material{normal::linear{100}}, boundary::walls{}, velocity_verlet{1e-3, {0, 0, -10}}, unchecked};
  s.add({{0, 0, 0}, 1, kilogram});
  s.add({{0, 0, 1.9}, 1, kilogram});
  s.start();
  // 10 N between them and 10 N weight each: the upper one is in balance, the lower one has 20 N
  CHECK(observe::unbalanced_force_ratio(s) == within(1e-12, 1));
}

TEST_CASE("energies have their entries: motion, height, springs, bridges") {
  const boundary::walls ground{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}};
  pendular::system s{material{normal::linear{100}, friction::coulomb_spring{50, 0.5}, energy_book{}}, ground,
                     velocity_verlet{1e-3, {0, 0, -10}}, unchecked};
  s.add({{0, 0, 0.9}, 1, kilogram, {0, 0, 0.6}, {3, 0, 0}});
  s.add({{0, 0, 2.7}, 1, kilogram, {0, 0, -0.8}});
  s.start();
  const auto e = observe::energies_of(s);
  CHECK(e.kinetic == within(1e-12, 0.5 * 0.36 + 0.5 * 0.64 + 0.5 * 0.4 * 9));
  CHECK(e.gravity == within(1e-12, 10 * 0.9 + 10 * 2.7));
  CHECK(e.elastic == within(1e-12, 50 * 0.01 + 50 * 0.04));
  CHECK((e.capillary == 0 && e.liquid == 0 && e.walls == 0));
  CHECK(e.balance() == within(1e-12, e.kinetic + e.gravity + e.elastic + e.damping + e.friction));
}

TEST_CASE("a bridge holds the work that would open it, and its making set that free") {
  pendular::system s{material{normal::linear{1e3}, energy_book{}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}}, boundary::walls{},
                     velocity_verlet{1e-7}};
  s.add({{0, 0, 0}, 0.5e-3, 2600});
  s.add({{1e-3, 0, 0}, 0.5e-3, 2600});
  s.distribute_liquid(1.25e-12);
  const auto e = observe::energies_of(s);
  CHECK(e.capillary == within(5e-6, -9.35241e-9));
  CHECK(e.liquid == within(5e-6, 9.35241e-9));
  CHECK(e.balance() == near(1e-20, 0));
}

TEST_CASE("the balance subtracts the work of the walls and does not count springs twice") {
  const observe::energies e{1, 2, 4, 8, -16, 32, 64, 128, 256};
  CHECK(e.balance() == 1 + 2 + 4 - 16 + 32 + 64 + 128 - 256);
  const observe::energies before{0, 1, 0, 0, 0, 30, 60, 120, 200};
  CHECK(e.turnover_since(before) == 56);  // of the walls; 14 were lost and 1 fell
}

TEST_CASE("what grains have fallen is the difference of their heights") {
  CHECK(observe::energies{.gravity = 7}.turnover_since({.gravity = 9}) == 2);
  CHECK(observe::energies{.gravity = -4}.turnover_since({.gravity = -9}) == 5);
}

TEST_CASE("grains that just meet do not touch") {
  pendular::system s{material{normal::linear{100}}, boundary::walls{}, velocity_verlet{1e-3}, unchecked};
  s.add({{0, 0, 0}, 1, kilogram});
  s.add({{2, 0, 0}, 1, kilogram});
  s.start();
  CHECK(s.contacts().gap()[0] == 0);
  CHECK(observe::coordination_of(s).contacts == 0);
}
