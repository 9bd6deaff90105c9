// SPDX-License-Identifier: BSD-3-Clause
#include "every_scalar.hpp"

using namespace every_scalar;

TEST_CASE("capillary laws 1 to 7 of the list in every scalar") {
  check_pulls(examples::some_of<0, 7>(law::capillary_laws));
}
