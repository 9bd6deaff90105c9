// SPDX-License-Identifier: BSD-3-Clause
// The law kits find what they look for, and nothing else.
#include "bad_laws.hpp"
#include "../catch.hpp"

#include <pendular/testing/law_kits.hpp>

#include <initializer_list>
#include <string_view>

using namespace pendular;
using namespace pendular::bad;
using testing::report;

namespace {

/// The report has exactly these lines, each named by its beginning.
void check_found(const report& found, std::initializer_list<std::string_view> expected) {
  for (const std::string& line : found) {
    INFO(line);
    bool known = false;
    for (const std::string_view beginning : expected) known = known || line.starts_with(beginning);
    CHECK(known);
  }
  CHECK(found.size() == expected.size());
}

}  // namespace

TEST_CASE("the normal kit finds a broken promise") {
  using enum bad_spring::mistake;
  const auto of = [](auto made) { return testing::normal_law_report(bad_spring{made}); };
  check_found(of(none), {});
  check_found(of(pulls_apart), {"the repulsion must not be negative", "the repulsion must be zero out of contact"});
  check_found(of(shallow), {"the repulsion must grow", "the stiffness must be", "the energy must be"});
  check_found(of(preloaded), {"the repulsion must start from zero", "the energy must be"});
  check_found(of(lopsided), {"the repulsion must not change when i and j are exchanged"});
  check_found(of(wrong_energy), {"the energy must be the work"});
  check_found(of(wrong_stiffness), {"the stiffness must be the slope", "the energy must be"});
  check_found(testing::normal_law_report(spring_in_double_only{}),
              {"the repulsion must be the same in float", "the repulsion must be the same in lanes of double",
               "the repulsion must be the same in lanes of float", "the repulsion must be the same under automatic"});
  check_found(
      testing::normal_law_report(spring_that_mixes_lanes{}),
      {"the repulsion must be the same in lanes of double", "the repulsion must be the same in lanes of float"});
  check_found(testing::normal_law_report(spring_said_to_be_linear{}), {"a stiffness said to be constant"});
  check_found(testing::normal_law_report(spring_that_never_forgets{}), {"what a normal law remembers must be zero"});
  const report blown_up = testing::normal_law_report(spring_that_blows_up{});
  CHECK(blown_up.front().starts_with("the repulsion must be finite"));
}

TEST_CASE("a counterexample shows numbers that can be told apart") {
  report broken;
  testing::demand(broken, false, "they differ", {{"found", 1.00000000001}, {"expected", 1.0}, {"gap", 2.0}});
  CHECK(broken.front() == "they differ: found = 1.00000000001, expected = 1, gap = 2");
}

TEST_CASE("the damping kit finds a broken promise") {
  using enum bad_dashpot::mistake;
  const auto of = [](auto made) { return testing::damping_law_report(bad_dashpot{made}); };
  check_found(of(none), {});
  check_found(of(as_printed), {"the resistance must dissipate"});
  check_found(of(everywhere), {"the resistance must be zero out of contact"});
  check_found(of(dry_friction), {"the resistance must be zero at zero speed"});
  check_found(of(lopsided), {"the resistance must not change when i and j are exchanged"});
  check_found(of(blows_up), {"the resistance must be finite", "the resistance must be zero out of contact",
                             "the resistance must be zero at zero speed",
                             "the resistance must not change when i and j are exchanged"});
  check_found(testing::damping_law_report(dashpot_prepared_wrongly{}), {"the prepared resistance must be that"});
  check_found(testing::damping_law_report(dashpot_that_never_forgets{}), {"what a damping law remembers must be zero"});
  CHECK(testing::damping_law_report(dashpot_in_double_only{}).size() == 4);
}

TEST_CASE("the friction kit finds a broken promise") {
  using enum bad_friction::mistake;
  const auto of = [](auto made) { return testing::friction_law_report(bad_friction{made}, 0.4); };
  check_found(of(none), {});
  check_found(of(pushes), {"the traction must oppose the slip"});
  check_found(of(uncapped), {"the traction must stay inside the Coulomb cone"});
  CHECK(of(zero_by_zero).front().starts_with("the traction must be finite"));
  CHECK(of(breakaway).front().starts_with("the traction must be zero at zero slip"));
  check_found(of(along_normal), {"the traction must lie in the tangent plane", "the traction must be parallel"});
  check_found(of(skewed), {"the traction must be parallel to the slip"});
  check_found(testing::friction_law_report(spring_capped_too_late{}, 0.4),
              {"the traction must stay inside the Coulomb"});
  check_found(testing::friction_law_report(bad_friction{none}, 0.3),
              {"the traction must stay inside the Coulomb cone"});
  CHECK(testing::friction_law_report(friction_in_double_only{}, 0.4).size() == 4);
}

TEST_CASE("the capillary kit finds a broken promise") {
  using enum bad_bridge::mistake;
  const auto of = [](auto made) { return testing::capillary_law_report(bad_bridge{made}, fluid::water()); };
  check_found(of(none), {});
  check_found(of(repels), {"the attraction must not be negative", "the attraction must stay finite"});
  check_found(of(gap_only), {"the attraction must be the same from both sides", "the attraction must not grow"});
  check_found(of(grows), {"the attraction must not grow with the gap"});
  check_found(of(larger_radius_j), {"the attraction must not change when i and j are exchanged"});
  check_found(of(dimensional), {"the attraction must scale as a length"});
  check_found(of(dries_to_nan), {"the attraction must stay finite as the volume vanishes"});
  check_found(testing::capillary_law_report(bridge_with_wrong_energy{{none}}, fluid::water()),
              {"the energy must be the work"});
  check_found(testing::capillary_law_report(bridge_of_two_minds{{none}}, fluid::water()),
              {"the simple and the prepared attraction must be the same"});
  CHECK(testing::capillary_law_report(bridge_in_double_only{}, fluid::water()).size() == 4);
}

TEST_CASE("the rupture kit finds a broken promise") {
  using enum bad_rupture::mistake;
  const auto of = [](auto made) { return testing::rupture_law_report(bad_rupture{made}, fluid::water()); };
  check_found(of(none), {});
  check_found(of(shrinks), {"the rupture distance must grow", "the rupture distance must not change when",
                            "the rupture distance must scale"});
  check_found(of(film), {"the rupture distance must be zero without liquid"});
  check_found(of(of_the_gap), {"the rupture distance must not depend on the gap"});
  check_found(of(lopsided), {"the rupture distance must not change when i and j are exchanged"});
  check_found(of(dimensional), {"the rupture distance must scale as a length"});
  check_found(of(blows_up), {"the rupture distance must be zero without liquid"});
  CHECK(testing::rupture_law_report(rupture_in_double_only{}, fluid::water()).size() == 4);
}

TEST_CASE("the viscous bridge kit finds a broken promise") {
  using enum bad_drag::mistake;
  const auto of = [](auto made) { return testing::viscous_bridge_law_report(bad_drag{made}, fluid::water()); };
  check_found(of(none), {});
  check_found(of(drives), {"the resistance of a bridge must not be negative"});
  check_found(of(dry), {"the resistance of a bridge must be zero without liquid"});
  check_found(of(lopsided), {"the resistance of a bridge must not change when i and j are exchanged"});
  CHECK(of(blows_up).front().starts_with("the resistance of a bridge must be finite"));
  CHECK(testing::viscous_bridge_law_report(drag_in_double_only{}, fluid::water()).size() == 4);
}
