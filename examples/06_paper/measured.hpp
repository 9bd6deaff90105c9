// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

namespace paper {

/// A mean over runs that differ by their seed, with its standard error; one run alone has none.
struct measured {
  double mean = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

inline measured mean_of(const std::vector<double>& values) {
  const auto n = static_cast<Eigen::Index>(values.size());
  if (n == 0) return {};
  const Eigen::Map<const Eigen::ArrayXd> x(values.data(), n);
  const double squares = (x - x.mean()).square().sum(), count = static_cast<double>(n);
  return {x.mean(), std::sqrt(squares / (count - 1) / count)};
}

}  // namespace paper
