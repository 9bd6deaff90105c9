// SPDX-License-Identifier: BSD-3-Clause
#include "test.hpp"

void run_test(const options& o, const pendular::friction::coulomb_spring& friction, const restart& from,
              const pendular::scene::monitor& watch) {
  test::with_friction(o, friction, from, watch);
}
