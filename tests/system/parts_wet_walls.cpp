// SPDX-License-Identifier: BSD-3-Clause
// Wettable walls in parts.
#include "in_parts.hpp"

#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/rupture/willett.hpp>

using namespace in_parts;

namespace {

template <class Options>
auto shake_wet(const Options& options) {
  pendular::system s{material{normal::linear{4e3}, damping::viscous{0.03}, friction::coulomb_spring{3e3, 0.4}},
                     liquid{fluid::water(), capillary::bagheri{}, rupture::willett{}, protocol::neighbours{}},
                     dragged_box(boundary::wettable{}), velocity_verlet{dt, sideways}, options};
  fill(s);
  s.run(300);
  s.distribute_liquid(1e-12 * 216);
  s.run(6000);
  return s;
}

}  // namespace

TEST_CASE("wettable walls do not see the parts of a scene") {
  const auto live = [](const auto& options) { return shake_wet(options); };
  const record whole = in_one_piece(live);
  CHECK(whole.ruptures + whole.formations > 500);
  check_parts(whole, live);
}
