// SPDX-License-Identifier: BSD-3-Clause
// A boundary of a user's own in a checkpoint.
#include "box_of_sides.hpp"
#include "resumed.hpp"

using namespace sides;

TEST_CASE("a boundary of one's own goes on with the same bits after a resume") {
  auto s = dry_scene(dry_sides());
  fill(s);
  check_resume(s, dry_scene(dry_sides()), 2500, [](const auto& seen) { return all_that_is_kept(seen); });
  CHECK(s.walls().lid.load.hardest > 0);
}
