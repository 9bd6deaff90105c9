// SPDX-License-Identifier: BSD-3-Clause
// What is done to the liquid of a whole scene, in parts: protocol 1, sources and sinks, grains that are taken out or driven.
#include "in_parts.hpp"

#include <pendular/liquid/source/all.hpp>

using namespace in_parts;

namespace {

template <class Options>
auto shake(const Options& options) {
  pendular::system s{material{normal::linear{4e3}, damping::viscous{0.03}, friction::coulomb_spring{3e3, 0.4}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::homogeneous{150},
                            source::evaporation{1e-7, 1e-6, 100}, source::wetting{1e-14, 70}},
                     dragged_box(), velocity_verlet{dt, sideways}, options};
  fill(s);
  s.run(300);
  s.distribute_liquid(1e-12 * 216, {.thinning = 1.5, .seed = 7, .film_thickness = 1e-8});
  s.run(2000);
  s.drive(100, {0.1, 0.05, 0});
  const std::vector<std::int64_t> gone{17, 60, 130};
  s.remove(gone);
  s.run(2000);
  s.exchange("by hand", [](auto& door) {
    const double films = door.sum_over_grains([&](std::size_t grain) { return door.film(grain); });
    const double bridges = door.sum_over_bridges([&](std::size_t pair) { return door.bridge_at(pair).volume; });
    door.for_each_bridge([&](std::size_t pair) {
      door.drain_bridge(pair, door.bridge_at(pair).volume * films / (films + 4 * bridges));
    });
  });
  s.release(100);
  s.run(2000);
  return s;
}

/// Pairs of equal grains at the same gap, of which the liquid is enough for some, and before them one that is wider.
template <class Options>
auto ties(const Options& options) {
  pendular::system s{material{normal::linear{4e3}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                     boundary::walls{}, velocity_verlet{1e-7}, options};
  const double r = 0x1p-11, near = 2 * r + 0x1p-17, far = 2 * r + 0x1.1p-17;
  for (int k = 0; k < 4; ++k) {
    const double x = k == 0 ? 0 : 0x1p-7, y = 0x1p-8 * k;
    s.add({.position = {x, y, 0}, .radius = r, .density = 2600});
    s.add({.position = {x, y, k == 0 ? far : near}, .radius = r, .density = 2600});
  }
  s.start();
  const double volume = 0x1p-17 * 0x1p-17 * 0x1p-17;  // with which the rupture distance is the gap of the near ones
  s.distribute_liquid(2.5 * volume, {});
  return s;
}

}  // namespace

TEST_CASE("protocol 1, sources and what a user does by hand do not see the parts of a scene") {
  const auto live = [](const auto& options) { return shake(options); };
  const record whole = in_one_piece(live);
  CHECK(whole.ruptures > 500);
  CHECK(whole.grains.size() == 213);
  check_parts(whole, live);
}

TEST_CASE("of pairs that would join together and are all on one part the first get a bridge") {
  const auto live = [](const auto& options) { return ties(options); };
  const record whole = in_one_piece(live);
  using key = std::pair<std::int64_t, std::int64_t>;
  REQUIRE(whole.bridges.size() == 2);
  CHECK((whole.bridges.contains(key{2, 3}) && whole.bridges.contains(key{4, 5})));
  slab_house house({4e-3});
  check_same(whole, in_slabs_of(house, live));
}
