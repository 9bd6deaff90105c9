// SPDX-License-Identifier: BSD-3-Clause
// Every shipped law and every archetype keeps the promises of its concept.
#include "../catch.hpp"
#include "examples.hpp"

#include <pendular/testing/archetypes.hpp>
#include <pendular/testing/law_kits.hpp>

#include <boost/hana/for_each.hpp>

using namespace pendular;
namespace hana = boost::hana;

namespace {
template <class List, class Report>
void require_sound(List laws, const Report& report_of) {
  hana::for_each(laws, [&]<class L>(L) {
    for (const std::string& broken : report_of(examples::of<typename L::type>::value)) {
      FAIL_CHECK(typeid(typename L::type).name() << ": " << broken);
    }
    SUCCEED();
  });
}
}  // namespace

TEST_CASE("every normal law keeps its promises") {
  require_sound(law::normal_laws, [](const auto& l) { return testing::normal_law_report(l); });
  CHECK(testing::normal_law_report(testing::archetype::normal_law(1e3)).empty());
}

TEST_CASE("every damping law keeps its promises") {
  require_sound(law::damping_laws, [](const auto& l) { return testing::damping_law_report(l); });
  CHECK(testing::damping_law_report(testing::archetype::damping_law(0.1)).empty());
}

TEST_CASE("every friction law keeps its promises") {
  require_sound(law::friction_laws, [](const auto& l) { return testing::friction_law_report(l, 0.4); });
  CHECK(testing::friction_law_report(testing::archetype::friction_law(0.4), 0.4).empty());
  CHECK(testing::friction_law_report(testing::archetype::friction_law_with_memory(0.4), 0.4).empty());
}

TEST_CASE("every capillary law keeps its promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    require_sound(law::capillary_laws, [&](const auto& l) { return testing::capillary_law_report(l, f); });
    CHECK(testing::capillary_law_report(testing::archetype::capillary_law(3.0), f).empty());
    CHECK(testing::capillary_law_report(testing::archetype::prepared_capillary_law(3.0), f).empty());
  }
}

TEST_CASE("every rupture law keeps its promises") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    require_sound(law::rupture_laws, [&](const auto& l) { return testing::rupture_law_report(l, f); });
    CHECK(testing::rupture_law_report(testing::archetype::rupture_law(1.0), f).empty());
  }
}
