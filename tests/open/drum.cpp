// SPDX-License-Identifier: BSD-3-Clause
// Walls that turn: a drum and a disc that drag, and a blade, a user's own drive, that hits.
#include "../catch.hpp"

#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/turning.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numbers>

using namespace pendular;
using boundary::cylinder;
using boundary::plane;
using boundary::turning;
using boundary::wall;

namespace {

constexpr double radius = 0.5e-3, density = 2600, g = 9.81, mu = 0.5;
constexpr double mass = 4.0 / 3 * std::numbers::pi * radius * radius * radius * density;

auto sand() {
  return material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, mu}, energy_book{}};
}

/// A grain at rest on a surface that begins to move: it slides under mu m g for 2 U / (7 mu g) and then rolls, its centre
/// at 2/7 of the speed of the surface (a solid sphere: m v = I w / R from one friction force). Then its friction spring
/// swings, by mu g over its frequency of 4.5e4 1/s: 1e-4 m/s.
template <class System>
void check_sliding_then_rolling(System& s, double surface_speed, const vector& along) {
  const double until_rolling = 2 * surface_speed / (7 * mu * g);
  const auto steps = static_cast<std::int64_t>(until_rolling / s.integrator().time_step);
  s.run(steps / 2);
  CHECK(dot(s.particles()[0].velocity, along) == within(2e-2, 0.5 * 2 / 7.0 * surface_speed));
  s.run(steps);
  CHECK(dot(s.particles()[0].velocity, along) == within(2e-2, 2 / 7.0 * surface_speed));
}

/// Settled under gravity on what is below.
template <class System>
void settle(System& s) {
  s.run(4000);
  for (vector& v : s.particles().template get<column::velocity>()) v = {0, 0, 0};
  for (vector& v : s.particles().template get<column::angular_velocity>()) v = {0, 0, 0};
}

// [drive]
/// A blade on an axis: a plane through it that turns, by the user.
struct sweeping {
  vector axis_point{0, 0, 0};
  double rate;   // about z, rad/s
  double reach;  // m

  template <Scalar T>
  Vec3<T> velocity_at(const Vec3<T>& p) const {
    return {T(-rate) * (p.y - T(axis_point.y)), T(rate) * (p.x - T(axis_point.x)), T(0.0)};
  }
  vector pivot() const { return axis_point; }
  double approach_speed() const { return std::abs(rate) * reach; }
  void move(plane& blade, const boundary::wall_load&, double time_step) {
    const double c = std::cos(rate * time_step), s = std::sin(rate * time_step);
    const vector n = blade.normal;
    blade.normal = {c * n.x - s * n.y, s * n.x + c * n.y, n.z};
  }
};
// [/drive]
static_assert(boundary::Drive<sweeping, plane> && !boundary::Drive<sweeping, cylinder>);

}  // namespace

TEST_CASE("a drum stays where it is and drags a grain at its bottom until that rolls") {
  constexpr double drum_radius = 10e-3, rate = -5;
  pendular::system s{sand(),
                     boundary::walls{wall{cylinder{{0, 0.3, 0}, {0, 1, 0}, drum_radius},
                                          turning{.point = {0, 0, 0}, .axis = {0, 1, 0}, .rate = 0}}},
                     velocity_verlet{1e-6, {0, 0, -g}}};
  s.add({.position = {0, 0, -(drum_radius - radius)}, .radius = radius, .density = density});
  settle(s);
  auto& drum = boundary::get<0>(s.walls());
  drum.drive.rate = rate;  // right-handed about y: the bottom moves along +x for a negative rate
  s.run(200);
  // The grain slides: mu m g at the lever of the drum, against its turning.
  CHECK(drum.drive.torque.y == within(2e-2, -rate / std::abs(rate) * mu * mass * g * drum_radius));
  settle(s);
  const double before = drum.work;
  const observe::energies from = observe::energies_of(s);
  check_sliding_then_rolling(s, std::abs(rate) * drum_radius, {1, 0, 0});
  CHECK((drum.shape.point == vector{0, 0.3, 0} && drum.shape.direction == vector{0, 1, 0}));
  // The work of the drum: the friction force times the way of its surface while the grain slides.
  const double surface = std::abs(rate) * drum_radius;
  CHECK(drum.work - before == within(3e-2, mass * 2 / 7.0 * surface * surface));
  const observe::energies to = observe::energies_of(s);
  CHECK(to.balance() - from.balance() == near(2e-2 * (drum.work - before), 0.0));
}

TEST_CASE("the side of a drum moves upwards where its bottom moves sideways") {
  const turning drive{.point = {0, 0, 0}, .axis = {0, 1, 0}, .rate = 5};
  // w x r, w = 5 along y
  CHECK(drive.velocity_at(vector{0, 7, -10e-3}) == vector{-50e-3, 0, 0});
  CHECK(drive.velocity_at(vector{10e-3, -7, 0}) == vector{0, 0, -50e-3});
  CHECK(drive.approach_speed() == 0);
}

TEST_CASE("a turning disc drags a grain in proportion to its distance from the axis") {
  for (const double distance : {2e-3, 6e-3}) {
    pendular::system s{
        sand(),
        boundary::walls{wall{plane{{1, 1, 0}, {0, 0, 1}}, turning{.point = {0, 0, 0}, .axis = {0, 0, 1}, .rate = 0}}},
        velocity_verlet{1e-6, {0, 0, -g}}};
    s.add({.position = {distance, 0, radius}, .radius = radius, .density = density});
    settle(s);
    boundary::get<0>(s.walls()).drive.rate = 20;
    check_sliding_then_rolling(s, 20 * distance, {0, 1, 0});
    CHECK(boundary::get<0>(s.walls()).shape.normal == vector{0, 0, 1});
  }
}

TEST_CASE("a blade of one's own and a shipped one hit a grain away at twice their speed where they meet it") {
  constexpr double rate = 20, distance = 5e-3;
  const auto check = [&](const auto& drive) {
    pendular::system s{material{normal::linear{1e3}}, boundary::walls{wall{plane{{0, 0, 0}, {0, 1, 0}}, drive}},
                       velocity_verlet{1e-6}};
    // a quarter of a turn away from the blade, which turns from the x axis towards y
    s.add({.position = {radius, distance, 0}, .radius = radius, .density = density});
    s.run(80000);
    const vector v = s.particles()[0].velocity;
    // It meets the blade where that stands at an angle a with sin a = (x - R) ... : the plane through the axis touches the
    // sphere at the foot of its centre, whose distance from the axis is sqrt(d^2 + x^2 - R^2) = d.
    CHECK(norm(v) == within(5e-3, 2 * rate * distance));
  };
  check(sweeping{.rate = rate, .reach = 10e-3});
  check(turning{.point = {0, 0, 0}, .axis = {0, 0, 1}, .rate = rate, .reach = 10e-3});
}

TEST_CASE("turning walls without meaning are refused") {
  const plane p{{0, 0, 0}, {0, 0, 1}};
  const double nan = std::nan("");
  CHECK_NOTHROW((wall{p, turning{{0, 0, 0}, {0, 0, 1}, -3}}));
  CHECK_THROWS_AS((wall{p, turning{{0, 0, 0}, {0, 0, 2}, 1}}), input_error);
  CHECK_THROWS_AS((wall{p, turning{{0, 0, 0}, {0, 0, 1}, nan}}), input_error);
  CHECK_THROWS_AS((wall{p, turning{{0, nan, 0}, {0, 0, 1}, 1}}), input_error);
  CHECK_THROWS_AS((wall{p, turning{{0, 0, 0}, {0, 0, 1}, 1, -1}}), input_error);
}
