// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/expects.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

using namespace pendular;

namespace {
std::string refusal(double value) {
  try {
    expects(value > 0, "the radius of a grain (m)", value, "positive and finite", "docs/reference/grains.md");
  } catch (const input_error& error) {
    return error.what();
  }
  return "accepted";
}
}  // namespace

TEST_CASE("a refusal says what was given, its value, the bound and where to read, in one sentence") {
  CHECK(refusal(-2.5e-4) ==
        "the radius of a grain (m) is -0.00025, but must be positive and finite (see docs/reference/grains.md)");
  CHECK(refusal(1) == "accepted");
}

TEST_CASE("values that are not finite are shown as such") {
  CHECK(refusal(std::nan("")).find(" is nan,") != std::string::npos);
  CHECK(refusal(-std::numeric_limits<double>::infinity()).find(" is -inf,") != std::string::npos);
}

TEST_CASE("bad input and a failed run are told apart by type") {
  static_assert(std::is_base_of_v<std::invalid_argument, input_error>);
  static_assert(std::is_base_of_v<std::runtime_error, run_error>);
  static_assert(!std::is_base_of_v<run_error, input_error>);
}
