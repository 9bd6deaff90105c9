// SPDX-License-Identifier: BSD-3-Clause
#include "cohesion.hpp"

#include "../common/markdown.hpp"
#include "curves.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>
#include <pendular/scene/grading.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace paper::shear {

namespace {

namespace fs = std::filesystem;
using examples::markdown::number;
using examples::markdown::table;
using pendular::io::curve_style;

constexpr std::array waters{"0", "0.0005", "0.002", "0.01", "0.02"};
constexpr std::array loads{"300", "550", "800"};
constexpr double paper_cohesion = 120, experiment_cohesion = 150;  // Pa, section 3.2.2

/// <group>/<prefix>_s<load> for all loads.
std::vector<seeds> under_all_loads(const fs::path& group, const std::string& prefix) {
  std::vector<seeds> all;
  for (const char* load : loads) all.push_back(three_runs_of(group / (prefix + "_s" + load)));
  return all;
}

std::string in_pascal(const measured& m) { return number("%.0f", m.mean, m.error); }

std::string with_tenth(const measured& m) { return number("%.1f", m.mean, m.error); }

double percent(const char* water) { return 100 * std::stod(water); }

/// Solid fraction of the sample when the lid is at a height.
double solid_fraction(const run& r, double height) {
  return r.number("sample", "solid_fraction") * 2 * r.number("sample", "split_height_m") / height;
}

void draw_loci(const std::vector<locus>& loci, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Yield loci in direct shear, all seeds, mean of their lines (Fig. 6a)";
  p.x_label = "normal stress on the plane between the halves (Pa)";
  p.y_label = "shear stress from 1 to 2 diameters (Pa)";
  p.x_range = p.y_range = {{0, 1100}};
  for (std::size_t k = 0; k < loci.size(); ++k) {
    const double cohesion = loci[k].cohesion().mean, tangent = loci[k].tan_friction().mean;
    const std::string label = "w = " + number("%g", percent(waters[k])) + " %";
    p.curves.push_back({label, loci[k].normal, loci[k].shear, curve_style::points, k, {}});
    p.curves.push_back({"", {0, 1100}, {cohesion, cohesion + 1100 * tangent}, curve_style::lines, k, {}});
  }
  pendular::io::draw(p, file);
}

template <class Cohesion>
pendular::io::curve cohesion_curve(const std::string& label, const std::vector<locus>& loci, const Cohesion& cohesion) {
  pendular::io::curve c{label, {}, {}, curve_style::linespoints, {}, {}};
  for (std::size_t k = 0; k < loci.size(); ++k) {
    const measured m = cohesion(loci[k]);
    c.x.push_back(percent(waters[k])), c.y.push_back(m.mean), c.error.push_back(m.error);
  }
  return c;
}

void draw_cohesion(const std::vector<locus>& loci, const std::vector<locus>& peaks, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Coulomb cohesion against water content (Fig. 6b)";
  p.x_label = "water content (%)";
  p.y_label = "cohesion (Pa)";
  p.x_range = {{-0.05, 2.1}};
  p.curves = {cohesion_curve("intercept, from 1 to 2 diameters", loci, [](const locus& l) { return l.cohesion(); }),
              cohesion_curve("beyond the dry line, from 1 to 2 diameters", loci,
                             [&](const locus& l) { return mean_of(beyond_dry_line(l, loci.front())); }),
              cohesion_curve("intercept at the peak", peaks, [](const locus& l) { return l.cohesion(); }),
              {"paper, simulation", {0.1, 2}, {paper_cohesion, paper_cohesion}, curve_style::dashed, {}, {}},
              {"paper, experiment", {1, 2}, {experiment_cohesion, experiment_cohesion}, curve_style::dashed, {}, {}}};
  pendular::io::draw(p, file);
}

/// Logarithmic slope over the grain size of what a sample of each size has, by least squares, seed by seed.
/// Errors: std::runtime_error for a size with other seeds than the first, or a value that has no logarithm.
measured exponent(const std::vector<double>& sizes, const std::vector<std::vector<double>>& values) {
  std::vector<double> slopes;
  for (std::size_t seed = 0; seed < values.front().size(); ++seed) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (values[k].size() != values.front().size() || !(values[k][seed] > 0)) {
        throw std::runtime_error("a grain size lacks a seed or has no cohesion: " + std::to_string(sizes[k]) + " m");
      }
      x.push_back(std::log(sizes[k])), y.push_back(std::log(values[k][seed]));
    }
    slopes.push_back(pendular::observe::coulomb_fit(x, y).tan_friction);
  }
  return mean_of(slopes);
}

}  // namespace

measured expected_cohesion(const locus& l, const run& any) {
  double high = 0, low = 0, cube = 0;
  for (const auto& c : pendular::scene::shear_grading()) {
    const double radius = any.numeric_option("scale") * c.diameter / 2;
    high += c.proportion * std::pow(radius, 1.5);
    low += c.proportion * std::sqrt(radius);
    cube += c.proportion * radius * radius * radius;
  }
  const double of_one = any.numeric_option("kappa") * high * low / (4 * std::numbers::pi * cube);
  std::vector<double> values;
  for (const seed_line& s : l.lines) {
    values.push_back(s.line.tan_friction * s.mean.bridges * solid_fraction(any, s.mean.height) * of_one);
  }
  return mean_of(values);
}

std::string yield_loci(const fs::path& folder, const fs::path& figures) {
  std::vector<locus> loci, peaks;
  table t({"w (%)", "bridges per grain", "angle (degrees)", "less dry", "cohesion (Pa)", "beyond the dry line (Pa)",
           "Rumpf (Pa)", "at the peak: angle (degrees)", "cohesion (Pa)", "over lid and weight: angle (degrees)",
           "cohesion (Pa)"});
  for (const char* water : waters) {
    const auto all = under_all_loads(folder / "yield_loci", "w" + std::string(water));
    const locus l = locus_of(all), at_peak = locus_of(all, peak_state),
                nominal = locus_of(all, residual_state_over_lid_and_weight);
    loci.push_back(l), peaks.push_back(at_peak);
    t.add({number("%g", percent(water)), number("%.2f", l.bridges().mean, l.bridges().error), with_tenth(l.angle()),
           with_tenth(added_angle(l, loci.front())), in_pascal(l.cohesion()),
           in_pascal(mean_of(beyond_dry_line(l, loci.front()))), in_pascal(expected_cohesion(l, all[0][0])),
           with_tenth(at_peak.angle()), in_pascal(at_peak.cohesion()), with_tenth(nominal.angle()),
           in_pascal(nominal.cohesion())});
  }
  draw_loci(loci, figures / "fig06a_yield_loci.png");
  draw_cohesion(loci, peaks, figures / "fig06b_cohesion.png");
  return t.text();
}

std::string grain_size(const fs::path& folder) {
  table t({"mean diameter (mm)", "angle, dry (degrees)", "wet", "intercept, dry (Pa)", "wet (Pa)",
           "wet beyond the dry line (Pa)", "times the diameter (N/m)", "Rumpf (Pa)"});
  std::vector<double> sizes;
  std::vector<std::vector<double>> cohesions;
  for (const std::string scale : {"0.5", "1", "2"}) {
    const auto wet_runs = under_all_loads(folder / "grain_size", "x" + scale + "_w0.01");
    const locus wet = locus_of(wet_runs), dry = locus_of(under_all_loads(folder / "grain_size", "x" + scale + "_w0"));
    cohesions.push_back(beyond_dry_line(wet, dry));
    const measured beyond = mean_of(cohesions.back());
    const double diameter = wet_runs.front().front().number("sample", "mean_diameter_m");
    sizes.push_back(diameter);
    t.add({number("%.3f", 1e3 * diameter), with_tenth(dry.angle()), with_tenth(wet.angle()), in_pascal(dry.cohesion()),
           in_pascal(wet.cohesion()), in_pascal(beyond),
           number("%.3f", beyond.mean * diameter, beyond.error * diameter),
           in_pascal(expected_cohesion(wet, wet_runs[0][0]))});
  }
  const measured slope = exponent(sizes, cohesions);
  t.add({"power of the diameter", "", "", "", "", number("%.2f", slope.mean, slope.error), "", ""});
  return t.text();
}

}  // namespace paper::shear
