// SPDX-License-Identifier: BSD-3-Clause
#include "curves.hpp"

#include "../common/curve.hpp"

#include <algorithm>

namespace paper {

namespace {

xy raw_curve(const run& r) {
  const auto table = r.curve();
  if (table.has("shear_stress_Pa")) {
    return {table["displacement_over_mean_diameter"], table["shear_stress_Pa"]};
  }
  const double diameter = r.number("sample", "mean_diameter_m");
  xy c{table["shortening_m"], table["axial_stress_Pa"]};
  for (double& x : c.x) x /= diameter;
  return c;
}

}  // namespace

xy stress_curve(const run& r) {
  xy c = raw_curve(r);
  c.y = examples::smoothed(c.x, c.y, 0.05);
  return c;
}

xy mean_curve(const seeds& s) {
  xy mean = stress_curve(s.front());
  for (std::size_t k = 1; k < s.size(); ++k) {
    const xy other = stress_curve(s[k]);
    const std::size_t count = std::min(mean.y.size(), other.y.size());
    mean.x.resize(count), mean.y.resize(count);
    for (std::size_t i = 0; i < count; ++i) mean.y[i] += other.y[i];
  }
  for (double& y : mean.y) y /= static_cast<double>(s.size());
  return mean;
}

double mean_between(const xy& curve, double from, double to) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (curve.x[k] >= from && curve.x[k] <= to) sum += curve.y[k], count += 1;
  }
  return sum / count;
}

double drops_per_diameter(const run& r, double share) {
  const xy c = raw_curve(r);
  const double mean = mean_between(c, 1, c.x.back());
  double drops = 0;
  for (std::size_t k = 0; k + 2 < c.y.size(); ++k) {
    if (c.x[k] < 1 || c.y[k] - c.y[k + 2] < share * mean) continue;
    drops += 1;
    k += 2;
  }
  return drops / (c.x.back() - 1);
}

}  // namespace paper
