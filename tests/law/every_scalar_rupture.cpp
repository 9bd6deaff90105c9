// SPDX-License-Identifier: BSD-3-Clause
#include "every_scalar.hpp"

using namespace every_scalar;

TEST_CASE("every rupture law in every scalar") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    for_each_law(law::rupture_laws, [&]<class L>(const L& law) {
      check_every_scalar(with_dry_bridges(validity_of<L>()), [&](const auto& b) { return law.distance(b, f); });
    });
  }
}

TEST_CASE("every capillary energy in every scalar") {
  for_each_law(law::capillary_laws, []<class L>(const L& law) {
    if constexpr (HasCapillaryEnergy<L>) {
      // rupture at 2^-10 m, the same number in every scalar and far enough not to cancel
      const auto energy = [&]<class T>(const bridge<T>& b) { return T(law.energy(b, fluid::water(), T(0x1p-10))); };
      check_every_scalar(testing::bridge_samples(validity_of<L>()), energy);
    }
  });
}
