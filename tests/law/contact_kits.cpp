// SPDX-License-Identifier: BSD-3-Clause
#include "kits.hpp"

using namespace kits;

TEST_CASE("every normal law keeps its promises") {
  require_sound(law::normal_laws, [](const auto& l) { return testing::normal_law_report(l); });
  CHECK(testing::normal_law_report(testing::archetype::normal_law(1e3)).empty());
  CHECK(testing::normal_law_report(testing::archetype::normal_law_with_memory(1e3)).empty());
}

TEST_CASE("every damping law keeps its promises") {
  require_sound(law::damping_laws, [](const auto& l) { return testing::damping_law_report(l); });
  CHECK(testing::damping_law_report(testing::archetype::damping_law(0.1)).empty());
  CHECK(testing::damping_law_report(testing::archetype::damping_law_beside_spring(0.1)).empty());
  CHECK(testing::damping_law_report(testing::archetype::damping_law_with_memory(0.1)).empty());
}

TEST_CASE("every friction law keeps its promises") {
  require_sound(law::friction_laws, [](const auto& l) { return testing::friction_law_report(l, 0.4); });
  CHECK(testing::friction_law_report(testing::archetype::friction_law(0.4), 0.4).empty());
  CHECK(testing::friction_law_report(testing::archetype::friction_law_with_memory(0.4), 0.4).empty());
}
