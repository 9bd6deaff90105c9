// SPDX-License-Identifier: BSD-3-Clause
// Walls that move, against springs written down here.
#include "../catch.hpp"

#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/turning.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/boundary/wall_contacts.hpp>
#include <pendular/contact/material.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace pendular;
using boundary::plane;
using boundary::servo_stress;
using boundary::wall;

namespace {
/// Lid over a spring of 2 kN/m that it meets at z = 1.
vector push_of_spring(const plane& lid) { return {0, 0, 2e3 * std::max(1 - lid.point.z, 0.0)}; }
}  // namespace

TEST_CASE("a fixed wall stays where it is under any force") {
  wall w{plane{{1, 2, 3}, {0, 0, 1}}};
  w.take({{1e9, 1e9, 1e9}}, 1);
  w.move(1);
  CHECK(w.shape.point == vector{1, 2, 3});
  CHECK(w.work == 0);
}

TEST_CASE("a wall at constant velocity does not notice what it meets") {
  wall w{plane{{0, 0, 1}, {0, 0, -1}}, boundary::constant_velocity{{0.5, 0, -2}}};
  for (int k = 0; k < 8; ++k) {
    w.take({{0, 0, 1e9}}, 0.125);
    w.move(0.125);
  }
  CHECK(w.shape.point == vector{0.5, 0, -1});
}

TEST_CASE("the work of a wall is the force it exerts along its way, taken by the trapezoidal rule") {
  wall w{plane{{0, 0, 1}, {0, 0, -1}}, boundary::constant_velocity{{0, 0, -2}}};
  w.take({{0, 0, 0}}, 0);
  CHECK(w.work == 0);
  w.take({{0, 0, 10}}, 0.1);  // 5 N on average over 0.2 m, against the wall's motion: the wall works
  CHECK(w.work == within(1e-15, 1));
  w.take({{3, 0, -10}}, 0.1);
  CHECK(w.work == within(1e-15, 1));
  w.take({{0, 0, -10}}, 0.1);  // a pull of the grains works on the wall
  CHECK(w.work == within(1e-15, -1));
  CHECK(w.force == vector{0, 0, -10});
}

TEST_CASE("pushing a spring in stores the wall's work") {
  wall w{plane{{0, 0, 1}, {0, 0, -1}}, boundary::constant_velocity{{0, 0, -1e-3}}};
  for (int k = 0; k < 1000; ++k) {
    w.move(1e-2);
    w.take({push_of_spring(w.shape)}, 1e-2);
  }
  CHECK(w.shape.point.z == within(1e-12, 0.99));
  CHECK(w.work == within(1e-10, 0.5 * 2e3 * 1e-4));
}

TEST_CASE("a servo comes to rest where the spring bears its stress, from above and from below, without a bounce") {
  // 300 Pa on 0.02 m2 are 6 N: 3 mm into the spring. Critical damping is 2 sqrt(k m) = 63 N s/m.
  for (const double start : {1.0, 1.0 - 6e-3}) {
    wall lid{plane{{0, 0, start}, {0, 0, -1}}, servo_stress{300, 0.02, 0.5, 80}};
    double lowest = start, highest = start;
    for (int k = 0; k < 40000; ++k) {
      lid.take({push_of_spring(lid.shape)}, 1e-4);
      lid.move(1e-4);
      lowest = std::min(lowest, lid.shape.point.z);
      highest = std::max(highest, lid.shape.point.z);
    }
    CHECK(lid.shape.point.z == within(1e-9, 0.997));
    CHECK(lid.force.z / 0.02 == within(1e-6, 300));
    CHECK(lowest >= std::min(start, 0.997) - 1e-9);
    CHECK(highest <= std::max(start, 0.997) + 1e-9);
    CHECK(std::abs(lid.drive.velocity.z) < 1e-9);
  }
}

TEST_CASE("a servo without resistance reaches the speed at which its dashpot bears the load") {
  wall lid{plane{{0, 0, 1}, {0, 0, -1}}, servo_stress{300, 0.02, 0.5, 80}};
  for (int k = 0; k < 4000; ++k) lid.move(1e-3);
  CHECK(lid.drive.velocity.z == within(1e-9, -6.0 / 80));
}

TEST_CASE("a servo is not dragged sideways and presses along its own normal") {
  wall lid{plane{{0, 0, 0}, {0.6, 0.8, 0}}, servo_stress{100, 0.01, 1, 10}};
  lid.take({{-0.8 * 5, 0.6 * 5, 7}}, 1e-3);  // across the normal
  lid.move(1e-3);
  CHECK(lid.drive.velocity.x == within(1e-12, 0.6 * 1e-3 / 1.01));
  CHECK(lid.drive.velocity.y == within(1e-12, 0.8 * 1e-3 / 1.01));
  CHECK(lid.drive.velocity.z == 0);
}

TEST_CASE("servos without meaning are refused where the wall is built") {
  const plane lid{{0, 0, 0}, {0, 0, -1}};
  const double nan = std::nan("");
  CHECK_NOTHROW((wall{lid, servo_stress{0, 1, 1, 0}}));
  CHECK_THROWS_AS((wall{lid, servo_stress{-1, 1, 1, 1}}), input_error);
  CHECK_THROWS_AS((wall{lid, servo_stress{1, 0, 1, 1}}), input_error);
  CHECK_THROWS_AS((wall{lid, servo_stress{1, 1, 0, 1}}), input_error);
  CHECK_THROWS_AS((wall{lid, servo_stress{1, 1, 1, -1}}), input_error);
  CHECK_THROWS_AS((wall{lid, servo_stress{nan, 1, 1, 1}}), input_error);
}

TEST_CASE("a lid slides along its plane, whatever part of the speed it is told points out of it") {
  boundary::plane lid{{0, 0, 1}, {0, 0, -1}};
  boundary::servo_stress servo{0, 1, 1, 0};
  servo.sliding = {0.2, 0, 1e-3};
  for (int k = 0; k < 1000; ++k) servo.move(lid, {0, 0, 0}, 1e-3);
  CHECK(servo.velocity.x == within(1e-12, 0.2));
  CHECK(servo.velocity.z == near(1e-12, 0.0));  // nothing presses
  CHECK(lid.point.x == within(1e-12, 0.2));
  CHECK(lid.point.z == within(1e-12, 1.0));
}

TEST_CASE("a wall pushes the grains that overlap it, and they push back with the same force") {
  using floor = wall<plane>;
  using stiff = material<normal::linear, friction::coulomb_spring>;
  grains<true, false> g;
  g.add({{0, 0, 0.9}, 1, 1000, {0.1, 0, 0}});           // 0.1 into the floor, sliding
  g.add({{9, 0, 1.5}, 1, 1000});                        // near
  g.add({{0, 9, 30}, 1, 1000});                         // far
  g.add({{0, 0, 1.8}, 2, 1000, {0, 0, 0}, {0, 3, 0}});  // 0.2 into it, turning about y
  const floor w{plane{{0, 0, 0}, {0, 0, 1}}};
  const stiff m{normal::linear{50}, friction::coulomb_spring{1000, 0.5}};
  boundary::wall_contacts<floor, stiff> contacts;
  contacts.rebuild(g, w, 1.0, std::vector<std::size_t>{0, 1, 2, 3});
  REQUIRE(contacts.size() == 3);
  contacts.evaluate(g, w, m, no_bonds{}, {1e-3, 0, 0.5});
  CHECK((contacts.row(0) == 0 && contacts.row(1) == 1 && contacts.row(2) == 3));
  CHECK(contacts.gap(0) == near(1e-15, -0.1));
  CHECK(contacts.gap(1) == 0.5);
  // 5 N up; the spring has been drawn 0.1 mm: 0.1 N against the sliding, on a lever of 0.9 below the centre
  CHECK(contacts.force(0).z == within(1e-13, 5));
  CHECK(contacts.force(0).x == within(1e-12, -0.1));
  CHECK(contacts.torque(0).y == within(1e-12, 0.09));
  CHECK(contacts.force(1) == vector{0, 0, 0});
  // the lowest point moves at w x r = (0, 3, 0) x (0, 0, -1.8) = (-5.4, 0, 0): 5.4 N would exceed mu N = 5 N
  CHECK(contacts.force(2).z == within(1e-13, 10));
  CHECK(contacts.force(2).x == within(1e-12, 5));
  CHECK(contacts.torque(2).y == within(1e-12, -9));
  const vector force = contacts.load(g, w).force;
  CHECK(force.z == within(1e-13, -15));
  CHECK(force.x == within(1e-12, -4.9));
  using sum = decltype(contacts)::load_sum_type;
  std::array<reproducible_sum, sum::width> sums;
  contacts.add_load(g, w, sum(sums));
  CHECK(sum(sums).value().force == force);
}

TEST_CASE("a grain that turns slips at a wall by its radius and gap, and its spring turns half as much as it does") {
  using floor = wall<plane>;
  using stiff = material<normal::linear, friction::coulomb_spring>;
  grains<true, false> g;
  g.add({{0, 0, 1.8}, 2, 1000, {0, 0, 0}, {0, 0.3, 0}});
  const floor w{plane{{0, 0, 0}, {0, 0, 1}}};
  const stiff m{normal::linear{50}, friction::coulomb_spring{1000, 0.5}};
  boundary::wall_contacts<floor, stiff> contacts;
  contacts.rebuild(g, w, 1.0, std::vector<std::size_t>{0});
  contacts.evaluate(g, w, m, no_bonds{}, {1e-3, 0, 0.5});
  CHECK(contacts.force(0).x == within(1e-12, 0.54));  // 1 kN/m times 0.3 / s times 1.8 m times 1 ms
  g.get<column::angular_velocity>()[0] = {0, 0, 100};
  contacts.evaluate(g, w, m, no_bonds{}, {1e-3, 0, 0.5});
  CHECK(contacts.force(0).y / contacts.force(0).x == within(1e-3, std::tan(0.05)));
}

TEST_CASE("a drum drags a grain with the velocity of its surface") {
  using drum = wall<boundary::cylinder, boundary::turning>;
  using stiff = material<normal::linear, friction::coulomb_spring>;
  grains<true, false> g;
  g.add({{0, 0, -2.1}, 1, 1000});  // 0.1 into it
  const drum w{boundary::cylinder{{0, 0, 0}, {0, 1, 0}, 3}, boundary::turning{{0, 0, 0}, {0, 1, 0}, 0.5}};
  const stiff m{normal::linear{50}, friction::coulomb_spring{1000, 0.5}};
  boundary::wall_contacts<drum, stiff> contacts;
  contacts.rebuild(g, w, 1.0, std::vector<std::size_t>{0});
  contacts.evaluate(g, w, m, no_bonds{}, {1e-3, 0, 0.5});
  CHECK(contacts.force(0).x == within(1e-12, -1.5));  // 1 kN/m times 0.5 / s times 3 m times 1 ms
}

TEST_CASE("a grain keeps its spring at the wall when the list is made anew in another order") {
  using floor = wall<plane>;
  using stiff = material<normal::linear, friction::coulomb_spring>;
  grains<true, false> g;
  for (int k = 0; k < 3; ++k) g.add({{3.0 * k, 0, 0.9}, 1, 1000, {0.1 * (k + 1), 0, 0}});
  const floor w{plane{{0, 0, 0}, {0, 0, 1}}};
  const stiff m{normal::linear{50}, friction::coulomb_spring{1000, 0.5}};
  boundary::wall_contacts<floor, stiff> contacts;
  contacts.rebuild(g, w, 1.0, std::vector<std::size_t>{0, 1, 2});
  contacts.evaluate(g, w, m, no_bonds{}, {1e-3, 0, 0.5});
  const std::vector<std::size_t> order{2, 0, 1};
  g.permute(order);
  contacts.rebuild(g, w, 1.0, order);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(contacts.row(k) == (k + 1) % 3);
    CHECK(contacts.memories().row(k).elastic_force.x == within(1e-12, -0.1 * static_cast<double>(k + 1)));
  }
}

TEST_CASE("a wall that moves counts the slip and the approach relative to itself") {
  using belt = wall<plane, boundary::constant_velocity>;
  using damped = material<normal::linear, damping::viscous, friction::coulomb_spring>;
  grains<true, false> g;
  g.add({{0, 0, 0.9}, 1, 3 / (4 * 3.14159265358979), {0.1, 0, 0.2}});  // 1 kg
  const belt w{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0.3, 0, 0.2}}};
  const damped m{normal::linear{50}, damping::viscous{0.5}, friction::coulomb_spring{1000, 0.5}};
  boundary::wall_contacts<belt, damped> contacts;
  contacts.rebuild(g, w, 1.0, std::vector<std::size_t>{0});
  contacts.evaluate(g, w, m, no_bonds{}, {1e-3, 0, 0.5});
  CHECK(contacts.force(0).z == within(1e-12, 5));    // no approach
  CHECK(contacts.force(0).x == within(1e-12, 0.2));  // dragged along
}
