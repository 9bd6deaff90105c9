// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pendular {

/// A running sum that keeps what rounding takes from it: the error of the sum of n numbers is that of one addition, and
/// does not grow with n.
/// Source: Neumaier 1974, Z. Angew. Math. Mech. 54, 39-51, algorithm IV.
struct compensated_sum {
  double sum = 0;
  double lost = 0;  // by rounding, to be added at the end

  void add(double v) {
    const double next = sum + v;
    lost += std::abs(sum) >= std::abs(v) ? (sum - next) + v : (v - next) + sum;
    sum = next;
  }
  double value() const { return sum + lost; }
};

}  // namespace pendular
