// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include <pendular/io/plot.hpp>
#include <pendular/io/table.hpp>
#include <pendular/observe/probability_density.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

struct density {
  std::vector<double> middle, value;  // of the bins
};

/// In bins of a tenth of the unit, between which 0 is an edge: no bin mixes both signs.
density density_of(const std::vector<double>& values, double unit, int low, int high) {
  std::vector<double> edges;
  for (int k = low; k <= high; ++k) edges.push_back(0.1 * k);
  density d{{}, pendular::observe::probability_density(values, unit, edges)};
  for (int k = low; k < high; ++k) d.middle.push_back(0.1 * (k + 0.5));
  return d;
}

density force_density(const options& o, const microstructure& m) {
  std::vector<double> forces = m.forces.compressive;
  for (const double f : m.forces.tensile) forces.push_back(-f);
  return density_of(forces, o.largest_pull(), -12, 100);
}
density pressure_density(const options& o, const microstructure& m) {
  return density_of(m.pressures, o.reference_pressure(), -40, 60);
}

void write(const options& o, const char* file, const char* name, const density& d) {
  pendular::io::write_table(o.output / file, pendular::io::table(std::vector<pendular::io::column>{
                                                 {name, d.middle}, {"probability_density", d.value}}));
}

pendular::io::plot picture(const options& o, const char* what, const char* label) {
  pendular::io::plot p;
  char title[160];
  std::snprintf(title, sizeof title, "%s, w = %g %%, %lld grains, compacted with friction %g", what,
                100 * o.water_content, static_cast<long long>(o.grains), o.preparation_friction);
  p.title = title;
  p.x_label = label;
  p.y_label = "probability density";
  p.logarithmic_y = true;
  return p;
}

/// A logarithmic axis has no place for an empty bin.
pendular::io::curve points(const density& d, const char* label) {
  pendular::io::curve c{label, d.middle, d.value, pendular::io::curve_style::linespoints, 0};
  for (double& y : c.y) y = y > 0 ? y : std::numeric_limits<double>::quiet_NaN();
  return c;
}

/// (alpha / 2) exp(-alpha |f| / f0), of integral 1, where the companion paper has forces.
pendular::io::curve slope_of_the_paper() {
  constexpr double alpha = 4;
  pendular::io::curve c{"slope 4 of the companion paper, -f0 to 2 f0", {}, {}, pendular::io::curve_style::dashed, 1};
  for (const double f : {-1.0, 0.0, 2.0}) c.x.push_back(f), c.y.push_back(0.5 * alpha * std::exp(-alpha * std::abs(f)));
  return c;
}

}  // namespace

void write_densities(const options& o, const microstructure& m) {
  write(o, "forces.csv", "force_over_f0", force_density(o, m));
  write(o, "pressures.csv", "pressure_over_p0", pressure_density(o, m));
}

void draw_densities(const options& o, const microstructure& m) {
  auto forces = picture(o, "Forces of pairs", "normal force over f0, compression positive");
  forces.curves = {points(force_density(o, m), "this sample"), slope_of_the_paper()};
  pendular::io::draw(forces, o.output / "forces.png");
  auto pressures = picture(o, "Pressures of grains", "pressure over p0 = f0 / d², compression positive");
  pressures.curves = {points(pressure_density(o, m), "this sample")};
  pendular::io::draw(pressures, o.output / "pressures.png");
}
