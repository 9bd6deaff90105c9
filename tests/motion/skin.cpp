// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/boundary/plane.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace pendular;

namespace {
// Time of a grain and step, ns: 3.5 pairs of 6 ns within one radius; a list of 600 ns, after as many steps as two grains
// can approach each other before they use up the skin.
double cost(double skin, double way) {
  const double steps_until_next = skin / (2 * way);
  return 3.5 * 6 * skin + 600 / steps_until_next;
}
double cheapest_of_many(double way) {
  double best = 0.1;
  for (double skin = 0.1; skin <= 1; skin *= 1.001) best = cost(skin, way) < cost(best, way) ? skin : best;
  return best;
}

auto gas(double speed, std::optional<double> skin) {
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.1}, friction::coulomb_spring{500, 0.3}},
                     boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                     velocity_verlet{1e-6, {0, 0, -9.81}}, run_options{.skin = skin}};
  for (int k = 0; k < 125; ++k) {
    const double phase = 1.7 * k;
    s.add({1.02e-3 * vector{k % 5 + 0.5, k / 5 % 5 + 0.5, k / 25 + 0.5}, 0.5e-3, 2700,
           speed * vector{std::cos(phase), std::sin(phase), std::cos(2 * phase)}});
  }
  return s;
}
}  // namespace

TEST_CASE("no skin is cheaper than the one that is chosen") {
  for (const double way : {1e-5, 2e-4, 1e-3, 1e-2, 0.1})
    CHECK(cheapest_skin(way) == within(2e-3, cheapest_of_many(way)));
}

TEST_CASE("grains at rest and grains beyond all speed still get a skin that works") {
  CHECK(cheapest_skin(0) == 0.1);
  CHECK(cheapest_skin(1e9) == 1);
}

TEST_CASE("the longest way is that of the fastest grain, or of what is faster") {
  auto s = gas(0.2, {});
  double fastest = 0;
  for (const vector& v : s.particles().get<column::velocity>()) fastest = std::max(fastest, norm(v));
  CHECK(longest_way(s.particles(), 0, 1e-6) == within(1e-15, 1e-6 * fastest));
  CHECK(longest_way(s.particles(), 2 * fastest, 1e-6) == within(1e-15, 2e-6 * fastest));
}

TEST_CASE("of several driven grains the fastest counts, wherever its id stands") {
  driven_grains driven;
  driven.add({2, {1, 0, 0}, {0, 0, 0}});
  driven.add({1, {0, 4, 3}, {0, 0, 0}});
  driven.add({0, {0, 0, 2}, {0, 0, 0}});
  CHECK(driven.fastest() == 5);
}

TEST_CASE("a fast wall and a fast driven grain widen the skin as a fast grain does") {
  // In one step of 1e-6 s a speed of 5 m/s is 1 % of the radius, for which a skin of sqrt(600 2 0.01 / 21) is the cheapest.
  const double wide = 0.5e-3 * std::sqrt(600 * 2 * 0.01 / 21);
  const auto range = [](double of_grain, double of_driven, double of_wall) {
    pendular::system s{material{normal::linear{1e3}},
                       boundary::walls{boundary::wall{boundary::plane{{0, 0, -1}, {0, 0, 1}},
                                                      boundary::constant_velocity{{0, 0, of_wall}}},
                                       boundary::wall{boundary::plane{{0, 0, -2}, {0, 0, 1}}}},
                       velocity_verlet{1e-6}};
    s.add({{0, 0, 0}, 0.5e-3, 2700, {of_grain, 0, 0}});
    s.add({{0, 1, 0}, 0.5e-3, 2700});
    s.drive(1, {0, of_driven, 0});
    s.start();
    return s.pairs().range();
  };
  CHECK(range(0, 0, 0) == within(1e-14, 0.1 * 0.5e-3));
  CHECK(range(5, 0, 0) == within(1e-14, wide));
  CHECK(range(0, 5, 0) == within(1e-14, wide));
  CHECK(range(0, 0, 5) == within(1e-14, wide));
}

namespace {
/// A grain and a floor that come towards each other.
auto meeting(double gap, double of_grain, double of_floor) {
  pendular::system s{material{normal::linear{1e3}},
                     boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}},
                                                    boundary::constant_velocity{{0, 0, of_floor}}}},
                     velocity_verlet{1e-6}, run_options{.skin = 0.2}};
  s.add({{0, 0, 0.5e-3 + gap}, 0.5e-3, 2700, {0, 0, -of_grain}});
  return s;
}
}  // namespace

TEST_CASE("a grain and a wall that come towards each other are listed before they meet") {
  auto s = meeting(1.01e-4, 0.045, 0.1);  // just beyond the skin
  s.run(1500);
  CHECK(s.particles().get<column::velocity>()[0].z == within(1e-3, 2 * 0.1 + 0.045));  // elastic
}

TEST_CASE("a wall asks for a new list once it has gone half of the skin since the last") {
  auto s = meeting(1, 0, 0.1);
  s.run(5250);
  CHECK(s.rebuild_count() == 11);
}

TEST_CASE("a scene at rest lists less than a fast one, and neither changes a bit of the result") {
  for (const double speed : {0.001, 0.5}) {
    auto chosen = gas(speed, {}), wide = gas(speed, 0.9);
    chosen.run(400), wide.run(400);
    const auto a = chosen.particles().rows_by_id(), b = wide.particles().rows_by_id();
    for (std::size_t id = 0; id < a.size(); ++id) {
      CHECK(chosen.particles().get<column::position>()[a[id]] == wide.particles().get<column::position>()[b[id]]);
      CHECK(chosen.particles().get<column::angular_velocity>()[a[id]] ==
            wide.particles().get<column::angular_velocity>()[b[id]]);
    }
    CHECK((chosen.pairs().range() < 0.2 * 0.5e-3) == (speed < 0.1));
  }
}
