// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/observe/coulomb_fit.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "../catch.hpp"

namespace {
using pendular::observe::coulomb_fit;
}

TEST_CASE("points on a line give the line without error", "[observe]") {
  const std::array normal{200.0, 500.0, 800.0}, shear{120 + 0.5 * 200, 120 + 0.5 * 500, 120 + 0.5 * 800};
  const auto line = coulomb_fit(normal, shear);
  CHECK(line.cohesion == within(1e-12, 120.0));
  CHECK(line.tan_friction == within(1e-12, 0.5));
  CHECK(line.friction_angle() == within(1e-12, 0.4636476090008061));
  CHECK(line.cohesion_error < 1e-9);
}

TEST_CASE("the standard errors are those of the textbook", "[observe]") {
  // x = 1, 2, 3, 4 and y = 2, 1, 4, 3 by hand: slope 0.6, intercept 1, residual squares 3.2, sigma^2 = 1.6
  const std::array x{1.0, 2.0, 3.0, 4.0}, y{2.0, 1.0, 4.0, 3.0};
  const auto line = coulomb_fit(x, y);
  CHECK(line.tan_friction == within(1e-12, 0.6));
  CHECK(line.cohesion == within(1e-12, 1.0));
  CHECK(line.scatter == within(1e-12, std::sqrt(1.6)));
  CHECK(line.tan_friction_error == within(1e-12, std::sqrt(1.6 / 5)));
  CHECK(line.cohesion_error == within(1e-12, std::sqrt(1.6 * 30 / (4 * 5))));
  CHECK(line.friction_angle_error() == within(1e-12, std::sqrt(1.6 / 5) / 1.36));
}

TEST_CASE("two points have no error, fewer no line", "[observe]") {
  const std::array x{300.0, 600.0}, y{200.0, 350.0};
  CHECK(coulomb_fit(x, y).cohesion == within(1e-12, 50.0));
  CHECK(std::isnan(coulomb_fit(x, y).cohesion_error));
  const std::array odd{0.1, 0.7}, thirds{1.0 / 3, 2.0 / 7};  // their line misses them by round-off
  CHECK(std::isnan(coulomb_fit(odd, thirds).cohesion_error));
  const std::vector<double> one{1.0}, same{3.0, 3.0}, two{1.0, 2.0};
  CHECK_THROWS_AS(coulomb_fit(one, one), pendular::input_error);
  CHECK_THROWS_AS(coulomb_fit(two, one), pendular::input_error);
  CHECK_THROWS_AS(coulomb_fit(same, two), pendular::input_error);
}
