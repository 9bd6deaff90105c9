// SPDX-License-Identifier: BSD-3-Clause
#include "kits.hpp"

using namespace kits;

namespace {
/// A law that comes to exactly 0 at a gap, by a difference that rounds differently in every scalar.
struct bridge_that_ends {
  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    const T mean = T(2) * b.radius_i * b.radius_j / (b.radius_i + b.radius_j);
    const T range = T(0.5) * pendular::cbrt(b.volume) + T(tiny);
    const T left = T(1) - max(b.gap, T(0)) / range;
    return T(capillary_tension(f)) * mean * max(left, T(0));
  }
};
}  // namespace

TEST_CASE("the archetypes of capillary laws keep their promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    CHECK(testing::capillary_law_report(testing::archetype::capillary_law(3.0), f).empty());
    CHECK(testing::capillary_law_report(testing::archetype::prepared_capillary_law(3.0), f).empty());
  }
}

TEST_CASE("a pull that ends at a gap is no broken promise") {
  for (const std::string& broken : testing::capillary_law_report(bridge_that_ends{}, fluid::water()))
    FAIL_CHECK(broken);
  SUCCEED();
}
