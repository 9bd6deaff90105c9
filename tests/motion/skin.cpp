// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

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
  for (const double way : {1e-5, 2e-4, 1e-3, 1e-2, 0.1}) CHECK(cheapest_skin(way) == within(2e-3, cheapest_of_many(way)));
}

TEST_CASE("grains at rest and grains beyond all speed still get a skin that works") {
  CHECK(cheapest_skin(0) == 0.1);
  CHECK(cheapest_skin(1e9) == 1);
}

TEST_CASE("the longest way is that of the fastest grain or wall") {
  auto s = gas(0.2, {});
  double fastest = 0;
  for (const vector& v : s.particles().get<column::velocity>()) fastest = std::max(fastest, norm(v));
  CHECK(longest_way(s) == within(1e-15, 1e-6 * fastest));
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
