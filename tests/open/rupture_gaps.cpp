// SPDX-License-Identifier: BSD-3-Clause
// A user's observer of events, written from outside: a histogram of the gaps at which bridges break.
#include "../catch.hpp"

#include <pendular/law/capillary/constant.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/grain_films.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

using namespace pendular;

namespace {

constexpr double radius = 0.5e-3, speed = 0.5;

// [observer]
/// Bins of one hundredth of a radius.
struct rupture_gaps {
  std::map<int, int> bins;
  std::vector<bridge_event> all;

  void notice(const bridge_event& event) {
    all.push_back(event);
    if (event.what == bridge_change::broke) ++bins[static_cast<int>(event.gap / (0.01 * radius))];
  }
};
// [/observer]

/// Pairs far from each other, each with a bridge of its own volume, flying apart at one speed along x.
auto flying_pairs(int count) {
  pendular::system s{material{normal::linear{1e3}},
                     liquid{fluid::water(), capillary::constant{}, rupture::lian{}, protocol::grain_films{}},
                     boundary::walls{}, velocity_verlet{1e-6}, run_options{.force = true}};
  for (int k = 0; k < count; ++k) {
    const double y = 0.02 * k;
    s.add({.position = {0, y, 0}, .radius = radius, .density = 1e12});
    s.add({.position = {2.001 * radius, y, 0}, .radius = radius, .density = 1e12, .velocity = {speed, 0, 0}});
  }
  s.start();
  s.exchange("syringe", [&](auto& door) {
    door.for_each_pair([&](std::size_t pair) {
      door.fill_bridge(pair, 1e-3 * std::pow(radius, 3) * static_cast<double>(1 + door.ids(pair).first / 2));
    });
  });
  return s;
}

}  // namespace

TEST_CASE("every rupture is told once, with the gap that the rupture law has for its volume") {
  auto s = flying_pairs(6);
  REQUIRE(s.bridges().count() == 6);
  rupture_gaps seen;
  s.run(400, seen);
  REQUIRE(s.bridges().count() == 0);
  REQUIRE(seen.all.size() == 6);
  for (const bridge_event& e : seen.all) {
    const double volume = 1e-3 * std::pow(radius, 3) * static_cast<double>(1 + e.ids.first / 2);
    CHECK(e.what == bridge_change::broke);
    CHECK(e.ids.second == e.ids.first + 1);
    CHECK(e.volume == within(1e-12, volume));
    // Lian et al. 1993: (1 + theta / 2) V^(1/3), found within one step of the way
    CHECK(e.gap >= std::cbrt(volume));
    CHECK(e.gap <= std::cbrt(volume) + 1.01 * speed * 1e-6);
    CHECK(static_cast<double>(e.step) == near(1.5, (e.gap - 1e-3 * radius) / (speed * 1e-6)));
  }
  int told = 0;
  for (const auto& [bin, count] : seen.bins) told += count;
  CHECK(told == 6);
  CHECK(seen.bins.begin()->first == 10);   // cbrt(1e-3)
  CHECK(seen.bins.rbegin()->first == 18);  // cbrt(6e-3)
}

TEST_CASE("being watched changes no bit") {
  auto watched = flying_pairs(3), alone = flying_pairs(3);
  rupture_gaps seen;
  for (int part = 0; part < 4; ++part) watched.run(100, seen);
  alone.run(400);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto a = watched.particles()[watched.particles().rows_by_id()[k]];
    const auto b = alone.particles()[alone.particles().rows_by_id()[k]];
    CHECK((a.position == b.position && a.velocity == b.velocity));
  }
  CHECK(seen.all.size() == 3);
}

TEST_CASE("a bridge that forms is told too, and one that is emptied by hand") {
  pendular::system s{material{normal::linear{1e3}},
                     liquid{fluid::water(), capillary::constant{}, rupture::lian{}, protocol::grain_films{}},
                     boundary::walls{}, velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({.position = {0, 0, 0}, .radius = radius, .density = 1e12});
  s.add({.position = {2.02 * radius, 0, 0}, .radius = radius, .density = 1e12, .velocity = {-0.1, 0, 0}});
  s.start();
  s.exchange("syringe", [](auto& door) { door.wet_grain(0, 1e-12); });
  rupture_gaps seen;
  s.run(150, seen);
  REQUIRE(seen.all.size() == 1);
  CHECK(seen.all[0].what == bridge_change::formed);
  CHECK(seen.all[0].volume == 1e-12);
  CHECK(seen.all[0].gap <= 0);
  CHECK(seen.all[0].gap >= -0.1e-6);
}

TEST_CASE("a run that an observer stops has made whole steps and goes on as if nothing had been") {
  auto stopped = flying_pairs(3), alone = flying_pairs(3);
  const auto refuse_at = [](std::int64_t step) {
    return [step](const auto& s) {
      if (s.step_count() == step) throw std::runtime_error("enough");
    };
  };
  CHECK_THROWS_AS(stopped.run(400, refuse_at(137)), std::runtime_error);
  CHECK(stopped.step_count() == 137);
  stopped.run(400 - 137);
  alone.run(400);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto a = stopped.particles()[stopped.particles().rows_by_id()[k]];
    const auto b = alone.particles()[alone.particles().rows_by_id()[k]];
    CHECK((a.position == b.position && a.velocity == b.velocity));
  }
}

TEST_CASE("an observer with a period looks at its multiples alone") {
  auto s = flying_pairs(1);
  std::vector<std::int64_t> looked;
  s.run(25, every{10, [&](const auto& now) { looked.push_back(now.step_count()); }});
  CHECK(looked == std::vector<std::int64_t>{10, 20});
  CHECK_THROWS_AS(s.run(10, every{0, [](const auto&) {}}), input_error);
  CHECK(s.step_count() == 25);
}
