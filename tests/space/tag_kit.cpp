// SPDX-License-Identifier: BSD-3-Clause
// Tags of grains keep their promises, and the kit finds one that does not.
#include "../found.hpp"

#include <pendular/testing/grain_tag.hpp>
#include <pendular/testing/role_archetypes.hpp>

using namespace pendular;
using testing::grain_tag_report;

namespace {
struct temperature {
  using type = double;
  static constexpr std::string_view label = "temperature", unit = "K";
};
struct nameless : temperature {
  static constexpr std::string_view label = "";
};
struct in_two_words : temperature {
  static constexpr std::string_view label = "the temperature";
};
struct another_radius : temperature {
  static constexpr std::string_view label = "radius";
};
struct without_unit : temperature {
  static constexpr std::string_view unit = "";
};
}  // namespace

TEST_CASE("tags of grains keep their promises, and the kit finds a broken one") {
  check_sound(grain_tag_report<temperature>());
  check_sound(grain_tag_report<testing::archetype::grain_tag>());
  CHECK(finds(grain_tag_report<nameless>(), "the label must be made of letters"));
  CHECK(finds(grain_tag_report<in_two_words>(), "the label must be made of letters"));
  CHECK(finds(grain_tag_report<another_radius>(), "the label must not be that of a column"));
  CHECK(finds(grain_tag_report<without_unit>(), "the unit must be there"));
}
