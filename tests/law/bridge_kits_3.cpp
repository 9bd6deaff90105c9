// SPDX-License-Identifier: BSD-3-Clause
#include "kits.hpp"

using namespace kits;

TEST_CASE("capillary laws from 10 of the list keep their promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    require_sound(examples::some_of<9, 99>(law::capillary_laws),
                  [&](const auto& l) { return testing::capillary_law_report(l, f); });
  }
}
