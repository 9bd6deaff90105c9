// SPDX-License-Identifier: BSD-3-Clause
// Dry grains in parts, with their energy book and with tags of one's own.
#include "in_parts.hpp"

#include <limits>
#include <string_view>

using namespace in_parts;

namespace {

struct heat {
  using type = double;
  static constexpr std::string_view label = "heat", unit = "J";
};
struct batch {
  using type = std::int64_t;
  static constexpr std::string_view label = "batch", unit = "1";
};
struct aim {
  using type = vector;
  static constexpr std::string_view label = "aim", unit = "1";
};

/// Whole numbers that would be no number, signalling or -0 as the bits of a double.
template <class System>
void tag(System& s) {
  auto& g = s.particles();
  for (std::size_t row = 0; row < g.size(); ++row) {
    const std::int64_t id = g.template get<column::id>()[row];
    constexpr std::int64_t odd_ones[] = {0x7ff0000000000001, std::numeric_limits<std::int64_t>::min(), -1};
    g.template get<batch>()[row] = odd_ones[id % 3] + id;
    g.template get<heat>()[row] = 0.1 * static_cast<double>(id);
    g.template get<aim>()[row] = {-0.0, 1e-310 * static_cast<double>(id), -HUGE_VAL};
  }
}

template <class Options>
auto shake_dry(const Options& options) {
  pendular::system s{
      material{normal::linear{4e3}, damping::viscous{0.03}, friction::coulomb_spring{3e3, 0.4}, energy_book{}},
      dragged_box(), half_step_velocity_verlet{dt, sideways}, tags<heat, batch, aim>{}, options};
  fill(s);
  tag(s);
  s.run(6000);
  return s;
}

/// Grains are put in that touch each other, and a list is made before their forces are known.
template <class Options>
auto touching_from_the_start(const Options& options) {
  pendular::system s{material{normal::linear{4e3}, damping::viscous{0.03}}, boundary::walls{}, velocity_verlet{dt},
                     options};
  for (const double x : {2e-3, 6e-3, 10e-3}) s.add({.position = {x, 0, 0}, .radius = radius, .density = 2600});
  s.run(10);
  for (int k = 1; k < 12; ++k) {
    for (const double x : {0.95e-3 * k, 0.95e-3 * k + 1.99 * radius}) {
      s.add({.position = {x, 2e-3 * k, 0}, .radius = radius, .density = 2600});
    }
  }
  s.canonicalise();
  s.start();
  s.run(10);
  return s;
}

}  // namespace

TEST_CASE("dry grains under a lid do not see the parts of a scene") {
  const auto live = [](const auto& options) { return shake_dry(options); };
  check_parts(in_one_piece(live), live);
}

TEST_CASE("grains put in touching push each other on all parts, even if they were listed before that") {
  const auto live = [](const auto& options) { return touching_from_the_start(options); };
  const record whole = in_one_piece(live);
  for (const std::vector<double>& borders : cuts) {
    slab_house house(borders);
    check_same(whole, in_slabs_of(house, live));
  }
}
