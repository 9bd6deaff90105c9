// SPDX-License-Identifier: BSD-3-Clause
// Shapes that turn, against places worked out by hand, and walls whose place or motion is no number.
#include "../catch.hpp"

#include <pendular/boundary/rimmed_cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/turning.hpp>
#include <pendular/boundary/wall.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace pendular;
using boundary::cylinder;
using boundary::plane;
using boundary::rimmed_cylinder;
using boundary::turning;
using boundary::wall;

namespace {
constexpr double pi = std::numbers::pi;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

void check_near(const vector& found, const vector& expected) {
  CHECK(found.x == near(1e-12, expected.x));
  CHECK(found.y == near(1e-12, expected.y));
  CHECK(found.z == near(1e-12, expected.z));
}
}  // namespace

TEST_CASE("a vector turns right-handed about an axis") {
  check_near(boundary::turned({1, 0, 0}, {0, 0, 1}, pi / 2), {0, 1, 0});
  check_near(boundary::turned({0, 1, 5}, {0, 0, 1}, pi / 2), {-1, 0, 5});
  check_near(boundary::turned({0, 0, 2}, {1, 0, 0}, -pi / 2), {0, 2, 0});
  // a third of a turn about the diagonal takes x to y to z
  check_near(boundary::turned({3, 0, 0}, (1 / std::sqrt(3.0)) * vector{1, 1, 1}, 2 * pi / 3), {0, 3, 0});
}

TEST_CASE("shapes turn about an axis that is not their own") {
  plane p{{3, 1, 0}, {1, 0, 0}};
  boundary::turn(p, {1, 1, 0}, {0, 0, 1}, pi / 2);
  check_near(p.point, {1, 3, 0});
  check_near(p.normal, {0, 1, 0});
  cylinder c{{2, 0, 0}, {0, 0, 1}, 1};
  boundary::turn(c, {0, 0, 0}, {0, 1, 0}, pi / 2);
  check_near(c.point, {0, 0, -2});
  check_near(c.direction, {1, 0, 0});
  rimmed_cylinder r{{2, 0, 0}, {0, 0, 1}, 1};
  boundary::turn(r, {2, 0, 0}, {1, 0, 0}, pi);
  check_near(r.point, {2, 0, 0});
  check_near(r.direction, {0, 0, -1});
}

TEST_CASE("what is round about the axis stays in itself, what is not does not") {
  const vector axis{0, 0, 1};
  CHECK(boundary::stays_in_itself(plane{{5, 5, 2}, {0, 0, -1}}, {0, 0, 0}, axis));
  CHECK_FALSE(boundary::stays_in_itself(plane{{0, 0, 0}, {0, 0.6, 0.8}}, {0, 0, 0}, axis));
  CHECK(boundary::stays_in_itself(cylinder{{0, 0, 7}, {0, 0, -1}, 1}, {0, 0, 0}, axis));
  CHECK_FALSE(boundary::stays_in_itself(cylinder{{0.1, 0, 7}, {0, 0, -1}, 1}, {0, 0, 0}, axis));
  CHECK_FALSE(boundary::stays_in_itself(cylinder{{0, 0, 7}, {0, 1, 0}, 1}, {0, 0, 0}, axis));
}

TEST_CASE("a million steps keep a turning plane a plane, where its angle says") {
  wall w{plane{{1, 0, 0}, {1, 0, 0}}, turning{.point = {0, 0, 0}, .axis = {0, 0, 1}, .rate = 2 * pi, .reach = 3}};
  for (int k = 0; k < 1'000'000; ++k) w.move(0.25e-6);  // a quarter of a turn
  CHECK(norm(w.shape.normal) == within(1e-15, 1));
  CHECK(w.shape.normal.y == within(1e-9, 1));
  CHECK(w.shape.point.y == within(1e-9, 1));
  CHECK(w.approach_speed() == within(1e-15, 6 * pi));
  w.drive.rate = -2 * pi;
  CHECK(w.approach_speed() == within(1e-15, 6 * pi));
}

TEST_CASE("a turning wall is told force and torque, and its power is that of its surface") {
  wall w{plane{{0, 0, 0}, {0, 0, 1}}, turning{.point = {0, 0, 0}, .axis = {0, 0, 1}, .rate = 3}};
  w.take({{0, 5, 0}, {0, 0, 10}, -30}, 0.1);
  w.move(0.1);
  CHECK(w.drive.torque == vector{0, 0, 10});
  CHECK((w.force == vector{0, 5, 0} && w.work == within(1e-15, -1.5)));  // trapezoidal rule, from no power
  CHECK(w.shape.normal == vector{0, 0, 1});
}

TEST_CASE("a wall that turning moves must say how far it reaches") {
  const turning without{{0, 0, 0}, {0, 0, 1}, 0};
  CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {1, 0, 0}}, without}), input_error);
  CHECK_THROWS_AS((wall{cylinder{{1, 0, 0}, {0, 0, 1}, 1}, without}), input_error);
  CHECK_NOTHROW((wall{plane{{0, 0, 0}, {0, 0, 1}}, without}));
  CHECK_NOTHROW((wall{cylinder{{0, 0, 3}, {0, 0, 1}, 1}, without}));
  CHECK_NOTHROW((wall{plane{{0, 0, 0}, {1, 0, 0}}, turning{{0, 0, 0}, {0, 0, 1}, 0, 1}}));
}

TEST_CASE("a place, a velocity or a rate that is no number is refused where the wall is built") {
  for (const double bad : {no_number, inf, -inf}) {
    CHECK_THROWS_AS((wall{plane{{0, bad, 0}, {0, 0, 1}}}), input_error);
    CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, bad}}}), input_error);
    CHECK_THROWS_AS((wall{cylinder{{bad, 0, 0}, {0, 0, 1}, 1}}), input_error);
    CHECK_THROWS_AS((wall{rimmed_cylinder{{0, 0, bad}, {0, 0, 1}, 1}}), input_error);
    CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0, bad, 0}}}), input_error);
    CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, 1}}, turning{{0, 0, 0}, {0, 0, 1}, bad}}), input_error);
    boundary::servo_stress lid{1, 1, 1, 1};
    lid.velocity.x = bad;
    CHECK_THROWS_AS((wall{plane{{0, 0, 0}, {0, 0, 1}}, lid}), input_error);
  }
}
