// SPDX-License-Identifier: BSD-3-Clause
#include "kits.hpp"

using namespace kits;

TEST_CASE("every rupture law keeps its promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    require_sound(law::rupture_laws, [&](const auto& l) { return testing::rupture_law_report(l, f); });
    CHECK(testing::rupture_law_report(testing::archetype::rupture_law(1.0), f).empty());
  }
}

TEST_CASE("every viscous bridge law keeps its promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    require_sound(law::viscous_bridge_laws, [&](const auto& l) { return testing::viscous_bridge_law_report(l, f); });
    CHECK(testing::viscous_bridge_law_report(testing::archetype::viscous_bridge_law(1.0), f).empty());
  }
}
