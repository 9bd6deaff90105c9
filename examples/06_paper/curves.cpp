// SPDX-License-Identifier: BSD-3-Clause
#include "curves.hpp"

#include "../common/curve.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace paper {

namespace {

constexpr double window = 0.05;  // mean diameters

/// Lines in which the lid has not yet met the sample as a whole; 0 if it never does.
std::size_t lines_without_load(const std::vector<double>& stress) {
  const double largest = *std::max_element(stress.begin(), stress.end());
  const auto first = std::find_if(stress.begin(), stress.end(), [=](double s) { return s > 0.05 * largest; });
  return first == stress.end() ? 0 : static_cast<std::size_t>(first - stress.begin());
}

xy shear_curve(const pendular::io::table& t) { return {t["displacement_over_mean_diameter"], t["shear_stress_Pa"]}; }

xy compression_curve(const pendular::io::table& t, double diameter) {
  xy c{t["shortening_m"], t["axial_stress_Pa"]};
  for (double& x : c.x) x /= diameter;
  const auto first = static_cast<std::ptrdiff_t>(lines_without_load(examples::smoothed(c.x, c.y, window)));
  const double origin = c.x[static_cast<std::size_t>(first)];
  c.x.erase(c.x.begin(), c.x.begin() + first), c.y.erase(c.y.begin(), c.y.begin() + first);
  for (double& x : c.x) x -= origin;
  return c;
}

double mean_of_column(const pendular::io::table& t, const char* name, double from, double to) {
  return mean_between({t["displacement_over_mean_diameter"], t[name]}, from, to);
}

}  // namespace

xy stress_curve(const run& r) {
  const auto table = r.curve();
  xy c = table.has("shear_stress_Pa") ? shear_curve(table)
                                      : compression_curve(table, r.number("sample", "mean_diameter_m"));
  c.y = examples::smoothed(c.x, c.y, window);
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

summit summit_of(const xy& curve) {
  const auto top = std::max_element(curve.y.begin(), curve.y.end());
  return {curve.x[static_cast<std::size_t>(top - curve.y.begin())], *top, curve.y.back() > 0.98 * *top};
}

shear_state state_between(const run& r, double from, double to) {
  const auto t = r.curve();
  const auto mean = [&](const char* name) { return mean_of_column(t, name, from, to); };
  const auto& x = t["displacement_over_mean_diameter"];
  if (x.empty() || x.back() < from) {
    throw std::runtime_error("the curve in " + r.folder().string() + " ends before " + std::to_string(from) +
                             " mean diameters");
  }
  return {mean("shear_stress_Pa"), mean("plane_stress_Pa"), mean("bridges_per_grain"), mean("height_m")};
}

shear_state residual_state(const run& r) { return state_between(r, 1, 2); }

shear_state peak_state(const run& r) {
  const summit top = summit_of(stress_curve(r));
  shear_state s = state_between(r, top.at - 0.1, top.at + 0.1);
  s.shear = top.stress;
  return s;
}

double falls_per_diameter(const run& r, double least) {
  const xy c = shear_curve(r.curve());
  double falls = 0, top = 0;  // the stress from which it falls
  bool counted = true;
  for (std::size_t k = 0; k < c.y.size(); ++k) {
    if (c.x[k] < 1) continue;
    if (k == 0 || c.x[k - 1] < 1 || c.y[k] >= c.y[k - 1]) {
      top = c.y[k], counted = false;
    } else if (!counted && top - c.y[k] > least) {
      falls += 1, counted = true;
    }
  }
  return falls / (c.x.back() - 1);
}

}  // namespace paper
