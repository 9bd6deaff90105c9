// SPDX-License-Identifier: BSD-3-Clause
#include "still.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {
double nine_tenths_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[values.size() * 9 / 10];
}
}  // namespace

still_grains still_grains_of(const examples::snapshot& s, double shortening) {
  constexpr auto slices = static_cast<std::size_t>(still_grains::slices);
  const double top = *std::max_element(s.z.begin(), s.z.end());
  std::array<std::vector<double>, slices> radii;
  std::array<double, slices> grains{};
  still_grains found;
  for (std::size_t k = 0; k < s.z.size(); ++k) {
    const auto slice =
        static_cast<std::size_t>(std::clamp(static_cast<int>(slices * s.z[k] / top), 0, still_grains::slices - 1));
    grains[slice] += 1;
    if (s.displacement[k] < 0.1 * shortening) radii[slice].push_back(std::hypot(s.x[k], s.y[k]));
  }
  for (std::size_t k = 0; k < slices; ++k) {
    const auto count = static_cast<double>(radii[k].size());
    found.share += count / static_cast<double>(s.z.size());
    found.by_slice[k] = grains[k] > 0 ? count / grains[k] : 0;
    found.radius[k] = nine_tenths_of(radii[k]);
  }
  return found;
}
