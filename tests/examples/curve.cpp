// SPDX-License-Identifier: BSD-3-Clause
// What the reports of the examples make of a curve.
#include "../catch.hpp"

#include "../../examples/common/curve.hpp"

#include <cmath>
#include <vector>

using examples::mean_beyond;
using examples::smoothed;

TEST_CASE("smoothing is the mean over the window, which is narrower at the ends on both sides") {
  const std::vector<double> x{0, 1, 2, 3, 4}, y{0, 3, 0, 3, 0};
  CHECK(smoothed(x, y, 0.5) == y);
  CHECK(smoothed(x, y, 2) == std::vector<double>{0, 1, 2, 1, 0});
  const std::vector<double> straight{0, 10, 20, 30, 40};
  CHECK(smoothed(x, straight, 3.9) == straight);
  CHECK(smoothed(x, straight, 100) == straight);
}

TEST_CASE("a mean beyond a place has the error of its ten stretches") {
  std::vector<double> x, y;
  for (int k = 0; k < 40; ++k) {
    x.push_back(k);
    y.push_back(k < 20 ? 1000 : k % 4 < 2 ? 3 : 5);  // from 20 on ten stretches of two: 3, 5, 3, 5 ...
  }
  const auto estimate = mean_beyond(x, y, 20);
  CHECK(estimate.mean == within(1e-15, 4));
  CHECK(estimate.error == within(1e-15, 1.0 / 3));  // sqrt(10 / (10 * 9))
}

TEST_CASE("nothing beyond the place gives no number") {
  const auto estimate = mean_beyond({0, 1, 2}, {5, 5, 5}, 1);
  CHECK((std::isnan(estimate.mean) && std::isnan(estimate.error)));
}
