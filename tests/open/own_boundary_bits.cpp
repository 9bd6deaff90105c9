// SPDX-License-Identifier: BSD-3-Clause
// A boundary of a user's own is, to the bit, the list of its walls.
#include "../found.hpp"
#include "box_of_sides.hpp"

#include <pendular/testing/boundary.hpp>

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace sides;

namespace {
/// The same as a list.
template <class Wetting, class Hard>
auto list_of(const box_of_sides<Wetting, Hard>& b) {
  return boundary::walls{b.floor, b.left, b.right, b.front, b.back, b.lid};
}
}  // namespace

TEST_CASE("a boundary of one's own gives the bits of the same walls in a list, on any number of threads") {
  auto listed = dry_scene(list_of(dry_sides()));
  fill(listed);
  listed.run(6000);
  const auto expected = all_that_moves(listed);
#ifdef _OPENMP
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
#endif
    auto named = dry_scene(dry_sides());
    fill(named);
    named.run(6000);
    CHECK(all_that_moves(named) == expected);

    CHECK(named.walls().lid.load.hardest > 0);
#ifdef _OPENMP
  }
  omp_set_num_threads(before);
#endif
}

TEST_CASE("a boundary of one's own keeps the promises of one") {
  check_sound(testing::boundary_report(dry_sides(), box{{0, 0, 0}, {side, side, side}}));
}
