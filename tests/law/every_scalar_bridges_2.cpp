// SPDX-License-Identifier: BSD-3-Clause
#include "every_scalar.hpp"

using namespace every_scalar;

TEST_CASE("capillary laws from 8 of the list in every scalar") {
  check_pulls(examples::some_of<7, 99>(law::capillary_laws));
}
