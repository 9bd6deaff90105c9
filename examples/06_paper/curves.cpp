// SPDX-License-Identifier: BSD-3-Clause
#include "curves.hpp"

#include "../common/curve.hpp"

#include <pendular/scene/packing.hpp>

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

/// From what the sample bears at rest: the first line of the table is ten micrometres later.
xy shear_curve(const run& r) {
  const auto t = r.curve();
  xy c{t["displacement_over_mean_diameter"], t["shear_stress_Pa"]};
  if (c.x.empty() || c.x.front() > 0) {
    c.x.insert(c.x.begin(), 0), c.y.insert(c.y.begin(), r.number("sample", "shear_stress_start_Pa"));
  }
  return c;
}

xy compression_curve(const pendular::io::table& t, double diameter) {
  xy c{t["shortening_m"], t["axial_stress_Pa"]};
  for (double& x : c.x) x /= diameter;
  const auto first = static_cast<std::ptrdiff_t>(lines_without_load(examples::smoothed(c.x, c.y, window)));
  const double origin = c.x[static_cast<std::size_t>(first)];
  c.x.erase(c.x.begin(), c.x.begin() + first), c.y.erase(c.y.begin(), c.y.begin() + first);
  for (double& x : c.x) x -= origin;
  return c;
}

/// A line of a curve may miss its end by rounding.
void expect_to_reach(const std::vector<double>& x, double to) {
  const double last = x.empty() ? 0 : x.back(), spacing = x.size() < 2 ? 0 : last - x[x.size() - 2];
  if (last + spacing <= to) {
    throw std::runtime_error("a curve ends at " + std::to_string(last) + " mean diameters, before " +
                             std::to_string(to));
  }
}

double mean_of_column(const pendular::io::table& t, const char* name, double from, double to) {
  return mean_between({t["displacement_over_mean_diameter"], t[name]}, from, to);
}

/// What the grains and the liquid above the plane weigh, over the area of the cell, Pa.
double weight_above(const run& r) {
  const pendular::scene::packing_parameters usual;
  return r.number("sample", "solid_fraction") * usual.density * (1 + r.numeric_option("water-content")) *
         usual.gravity * r.number("sample", "split_height_m");
}

}  // namespace

xy stress_curve(const run& r) {
  xy c = r.curve().has("shear_stress_Pa") ? shear_curve(r)
                                          : compression_curve(r.curve(), r.number("sample", "mean_diameter_m"));
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
  expect_to_reach(curve.x, to);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (curve.x[k] >= from && curve.x[k] <= to) sum += curve.y[k], count += 1;
  }
  return sum / count;
}

summit summit_of(const xy& curve) {
  expect_to_reach(curve.x, window);
  const auto first = std::lower_bound(curve.x.begin(), curve.x.end(), window) - curve.x.begin();
  const auto top = std::max_element(curve.y.begin() + first, curve.y.end());
  const double at = curve.x[static_cast<std::size_t>(top - curve.y.begin())];
  return {at, *top, at > curve.x.back() - 0.1};
}

double summit_over_residual(const run& r) {
  const xy c = stress_curve(r);
  return summit_of(c).stress / mean_between(c, 1, 2);
}

double early_over_residual(const run& r) {
  const xy c = stress_curve(r);
  return mean_between(c, 0.4, 0.8) / mean_between(c, 1, 2);
}

shear_state state_between(const run& r, double from, double to) {
  const auto t = r.curve();
  const auto mean = [&](const char* name) { return mean_of_column(t, name, from, to); };
  return {mean("shear_stress_Pa"), mean("plane_stress_Pa"), mean("bridges_per_grain"), mean("height_m"),
          mean("shared_area_over_cell")};
}

shear_state residual_state(const run& r) { return state_between(r, 1, 2); }

shear_state residual_state_over_lid_and_weight(const run& r) {
  shear_state s = residual_state(r);
  s.normal = mean_of_column(r.curve(), "lid_stress_Pa", 1, 2) + weight_above(r);
  return s;
}

shear_state peak_state(const run& r) {
  const summit top = summit_of(stress_curve(r));
  shear_state s =
      state_between(r, top.at - 0.1, std::min(top.at + 0.1, r.curve()["displacement_over_mean_diameter"].back()));
  s.shear = top.stress;
  return s;
}

double falls_per_diameter(const run& r, double least) {
  const xy c = shear_curve(r);
  expect_to_reach(c.x, 1);
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
