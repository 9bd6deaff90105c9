// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

/// Median; the mean of the two in the middle for an even number, no number for none.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}
