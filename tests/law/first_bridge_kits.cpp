// SPDX-License-Identifier: BSD-3-Clause
#include "kits.hpp"

#include <boost/hana/integral_constant.hpp>
#include <boost/hana/take_front.hpp>

using namespace kits;

// The others are in later_bridge_kits.cpp.
TEST_CASE("each of the first capillary laws keeps its promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    require_sound(boost::hana::take_front(law::capillary_laws, boost::hana::size_c<7>),
                  [&](const auto& l) { return testing::capillary_law_report(l, f); });
  }
}
