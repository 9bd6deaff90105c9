// SPDX-License-Identifier: BSD-3-Clause
// A boundary of a user's own in a checkpoint.
#include "box_of_sides.hpp"
#include "resumed.hpp"

using namespace sides;

TEST_CASE("a boundary of one's own goes on with the same bits after a resume") {
  auto s = dry_scene(dry_sides());
  fill(s);
  s.run(2500);
  auto again = resumed(s, dry_scene(dry_sides()));
  CHECK(again.walls().lid.load.hardest == s.walls().lid.load.hardest);
  s.run(2500);
  again.run(2500);
  CHECK(all_that_moves(again) == all_that_moves(s));
  CHECK(again.walls().lid.load.hardest == s.walls().lid.load.hardest);
  CHECK(s.walls().lid.load.hardest > 0);
}
