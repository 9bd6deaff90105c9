// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/how-to/own_source.md.
#include <pendular/pendular.hpp>
#include <pendular/testing/role_kits.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

// [source]
/// Water seeps away through the floor: of every film and bridge below a height a share is lost per second.
struct seepage {
  static constexpr std::string_view account = "ground";
  double height;               // m
  double rate;                 // 1/s
  std::int64_t period = 1000;  // steps

  template <class Door>
  void act(Door& door) const {
    const double share = 1 - std::exp(-rate * door.time_span());
    door.for_each_bridge([&](std::size_t pair) {
      const auto below = [&](std::size_t grain) { return door.position(grain).z < height; };
      if (below(door.first_grain(pair))) door.drain_bridge(pair, share * door.bridge_at(pair).volume);
    });
    door.for_each_grain([&](std::size_t grain) {
      if (door.position(grain).z < height) door.dry_grain(grain, share * door.film(grain));
    });
  }
};
static_assert(pendular::Source<seepage>);
// [/source]

using namespace pendular;

int main() {
  // [kit]
  for (const std::string& broken : testing::source_report(seepage{.height = 1, .rate = 100})) {
    std::printf("%s\n", broken.c_str());
  }
  // [/kit]
  const bool sound = testing::source_report(seepage{.height = 1, .rate = 100}).empty();
  // [chain]
  constexpr double radius = 0.5e-3, volume = 0.01 * radius * radius * radius;
  pendular::system chain{material{normal::linear{1e3}},
                         liquid{fluid::water(), capillary::richefeu{}, rupture::lian{},
                                seepage{.height = 1e-3, .rate = 100, .period = 100}},
                         boundary::walls{}, velocity_verlet{1e-6}};
  chain.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  chain.add({.position = {2 * radius, 0, 0}, .radius = radius, .density = 2600});
  chain.add({.position = {4 * radius, 0, 0}, .radius = radius, .density = 2600});
  chain.distribute_liquid(2 * volume);
  chain.run(1000);
  // [/chain]
  const ledger& book = chain.bridges().book();
  const double left = book.total() / (2 * volume), lost = book.outside("ground") / (2 * volume);
  // [by_hand]
  chain.exchange("syringe", [](auto& door) {
    door.for_each_grain([&](std::size_t grain) {
      if (door.id(grain) == 2) door.wet_grain(grain, 1e-12);  // m3
    });
  });
  // [/by_hand]
  std::printf("left %.6f, in the ground %.6f of what was put in; from the syringe %.1e m3\n", left, lost,
              -book.outside("syringe"));
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12; };
  const bool as_expected =
      near(left, std::exp(-0.1)) && near(left + lost, 1) && near(book.total() / 1e-12, left * 2 * volume / 1e-12 + 1);
  return sound && as_expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
