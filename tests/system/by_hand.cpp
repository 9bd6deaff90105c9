// SPDX-License-Identifier: BSD-3-Clause
// What a user changes by hand between runs counts at once, whether or not the neighbour list is made anew.
#include "../catch.hpp"

#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <limits>

using namespace pendular;

namespace {
constexpr double radius = 5e-4, density = 2600;
using soft = material<normal::linear, damping::viscous>;

auto on_a_plate(double height, double wall_stiffness, double time_step) {
  using boundary::plane;
  pendular::system s{soft{normal::linear{1e3}, damping::viscous{0.1}},
                     boundary::walls{boundary::wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{},
                                                    soft{normal::linear{wall_stiffness}, damping::viscous{0.1}}}},
                     velocity_verlet{time_step, {0, 0, -9.81}}};
  s.add({{0, 0, height * radius}, radius, density});
  return s;
}

auto touching_pair() {
  pendular::system s{soft{normal::linear{1e3}, damping::viscous{0.5}}, boundary::walls{}, velocity_verlet{1e-6}};
  s.add({{0, 0, 0}, radius, density});
  s.add({{0, 0, 1.999 * radius}, radius, density});
  return s;
}
}  // namespace

TEST_CASE("another material of a wall counts from the next step on") {
  auto plain = on_a_plate(0.9999, 1e3, 1e-6), listed = on_a_plate(0.9999, 1e3, 1e-6);
  auto untouched = on_a_plate(0.9999, 1e3, 1e-6);
  plain.run(5), listed.run(5), untouched.run(5);
  const soft damped{normal::linear{1e3}, damping::viscous{0.9}};
  boundary::get<0>(plain.walls()).material = damped;
  boundary::get<0>(listed.walls()).material = damped;
  listed.canonicalise();
  plain.run(30), listed.run(30), untouched.run(30);
  CHECK(plain.particles().get<column::position>()[0] == listed.particles().get<column::position>()[0]);
  CHECK(plain.particles().get<column::velocity>()[0].z < 0.9 * untouched.particles().get<column::velocity>()[0].z);
}

TEST_CASE("a grain whose inverse mass is set to 0 is held, and its partner meets a wall") {
  auto plain = touching_pair(), listed = touching_pair();
  for (auto* s : {&plain, &listed}) {
    s->run(1);
    const auto rows = s->particles().rows_by_id();
    s->particles().get<column::inverse_mass>()[rows[0]] = 0;
    s->particles().get<column::velocity>()[rows[0]] = {0, 0, 0};
  }
  listed.canonicalise();
  plain.run(200), listed.run(200);
  const auto a = plain.particles().rows_by_id(), b = listed.particles().rows_by_id();
  CHECK(plain.particles().get<column::velocity>()[a[1]] == listed.particles().get<column::velocity>()[b[1]]);
  CHECK(plain.particles().get<column::velocity>()[a[0]] == vector{0, 0, 0});
}

TEST_CASE("a stiff wall near a grain at rest is seen by the limit of the time step, whatever the skin") {
  for (const double height : {1.001, 1.05, 1.15}) CHECK_THROWS_AS(on_a_plate(height, 1e6, 3e-6).start(), input_error);
  on_a_plate(1.5, 1e6, 3e-6).start();
}

TEST_CASE("a radius that is no number is reported") {
  auto s = touching_pair();
  s.run(1);
  s.particles().get<column::radius>()[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(s.run(2), run_error);
}
