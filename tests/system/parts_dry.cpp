// SPDX-License-Identifier: BSD-3-Clause
// Dry grains in parts, with their energy book.
#include "in_parts.hpp"

using namespace in_parts;

namespace {

template <class Options>
auto shake_dry(const Options& options) {
  pendular::system s{
      material{normal::linear{4e3}, damping::viscous{0.03}, friction::coulomb_spring{3e3, 0.4}, energy_book{}},
      dragged_box(), half_step_velocity_verlet{dt, sideways}, options};
  fill(s);
  s.run(6000);
  return s;
}

}  // namespace

TEST_CASE("dry grains under a lid do not see the parts of a scene") {
  const auto live = [](const auto& options) { return shake_dry(options); };
  check_parts(in_one_piece(live), live);
}
