// SPDX-License-Identifier: BSD-3-Clause
#include "curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace examples {

namespace {
double mean_of(const double* begin, const double* end) {
  return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
}
}  // namespace

std::vector<double> smoothed(const std::vector<double>& x, const std::vector<double>& y, double window) {
  std::vector<double> values(y.size());
  std::size_t from = 0, to = 0;
  double sum = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double reach = std::min({0.5 * window, x[k] - x.front(), x.back() - x[k]});
    while (to < y.size() && x[to] <= x[k] + reach) sum += y[to++];
    while (x[from] < x[k] - reach) sum -= y[from++];
    values[k] = sum / static_cast<double>(to - from);
  }
  return values;
}

estimate mean_beyond(const std::vector<double>& x, const std::vector<double>& y, double from) {
  const auto first = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), from) - x.begin());
  const std::size_t count = y.size() - first;
  constexpr std::size_t stretches = 10;
  if (count < stretches) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const double mean = mean_of(y.data() + first, y.data() + y.size());
  double square = 0;
  for (std::size_t k = 0; k < stretches; ++k) {
    const double* begin = y.data() + first;
    square += std::pow(mean_of(begin + k * count / stretches, begin + (k + 1) * count / stretches) - mean, 2);
  }
  return {mean, std::sqrt(square / stretches / (stretches - 1))};
}

}  // namespace examples
