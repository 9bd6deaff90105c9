// SPDX-License-Identifier: BSD-3-Clause
#include "shear.hpp"

#include "../common/markdown.hpp"
#include "curves.hpp"
#include "loci.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>
#include <pendular/scene/grading.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace paper::shear {

namespace {

namespace fs = std::filesystem;
using examples::markdown::number;
using examples::markdown::table;
using pendular::io::curve_style;

constexpr std::array waters{"0", "0.0005", "0.002", "0.01", "0.02"};
constexpr std::array stresses{"300", "550", "800"};
constexpr double paper_cohesion = 120, experiment_cohesion = 150;  // Pa, section 3.2.2

seeds sheared(const fs::path& folder, const std::string& water, const std::string& stress) {
  return runs_of(folder / "yield_loci" / ("w" + water + "_s" + stress));
}

std::vector<seeds> all_stresses(const fs::path& folder, const std::string& water) {
  std::vector<seeds> all;
  for (const char* stress : stresses) all.push_back(sheared(folder, water, stress));
  return all;
}

pendular::io::plot shear_plot(const std::string& title) {
  pendular::io::plot p;
  p.title = title;
  p.x_label = "displacement over mean diameter";
  p.y_label = "shear stress (Pa)";
  return p;
}

void add(pendular::io::plot& p, const std::string& label, const xy& c, std::size_t colour,
         curve_style style = curve_style::lines) {
  p.curves.push_back({label, c.x, c.y, style, colour, {}});
}

measured residual(const seeds& s) {
  return mean_of(each(s, [](const run& r) { return r.number("strength", "residual_shear_stress_Pa"); }));
}
measured peak(const seeds& s) {
  return mean_of(each(s, [](const run& r) { return r.number("strength", "peak_shear_stress_Pa"); }));
}

std::string in_pascal(const measured& m) { return number("%.0f", m.mean, m.error); }

std::string cohesion(const mean_line& l) { return in_pascal(l.cohesion); }
std::string angle(const mean_line& l) { return number("%.1f", l.angle.mean, l.angle.error); }

/// Isotropic stress of capillary forces at contact in a packing whose sizes are not correlated, per neighbour by bridge:
/// Rumpf's for several sizes, solid fraction kappa <R^3/2> <R^1/2> / (4 pi <R^3>), Pa.
double capillary_pressure_per_bridge(double solid_fraction, double kappa) {
  double high = 0, low = 0, cube = 0;
  for (const auto& c : pendular::scene::shear_grading()) {
    const double radius = c.diameter / 2;
    high += c.proportion * std::pow(radius, 1.5);
    low += c.proportion * std::sqrt(radius);
    cube += c.proportion * radius * radius * radius;
  }
  return solid_fraction * kappa * high * low / (4 * std::numbers::pi * cube);
}

/// What the bridges would give as cohesion if all of them pulled with f_0: tan(phi) times their pressure.
std::string expected_cohesion(const locus& l, const run& any) {
  const double kappa = any.numeric_option("kappa"), fraction = any.number("sample", "solid_fraction");
  return number("%.0f",
                l.over_plane.tan_friction.mean * l.bridges.mean * capillary_pressure_per_bridge(fraction, kappa));
}

void draw_loci(const std::vector<locus>& loci, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Yield loci in direct shear, all seeds, mean of their lines (Fig. 6a)";
  p.x_label = "normal stress on the plane between the halves (Pa)";
  p.y_label = "residual shear stress (Pa)";
  p.x_range = {{0, 1100}};
  p.y_range = {{0, 1000}};
  for (std::size_t k = 0; k < loci.size(); ++k) {
    const auto& line = loci[k].over_plane;
    p.curves.push_back({"w = " + number("%g", 100 * std::stod(waters[k])) + " %",
                        loci[k].plane,
                        loci[k].shear,
                        curve_style::points,
                        k,
                        {}});
    p.curves.push_back({"",
                        {0, 1100},
                        {line.cohesion.mean, line.cohesion.mean + 1100 * line.tan_friction.mean},
                        curve_style::lines,
                        k,
                        {}});
  }
  pendular::io::draw(p, file);
}

void draw_cohesion(const std::vector<locus>& loci, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Coulomb cohesion against water content (Fig. 6b)";
  p.x_label = "water content (%)";
  p.y_label = "cohesion (Pa)";
  p.x_range = {{-0.05, 2.1}};
  pendular::io::curve lid{"over the stress of the lid", {}, {}, curve_style::linespoints, {}, {}};
  pendular::io::curve plane{"over the stress on the plane", {}, {}, curve_style::linespoints, {}, {}};
  for (std::size_t k = 0; k < loci.size(); ++k) {
    for (auto* c : {&lid, &plane}) c->x.push_back(100 * std::stod(waters[k]));
    lid.y.push_back(loci[k].over_lid.cohesion.mean), lid.error.push_back(loci[k].over_lid.cohesion.error);
    plane.y.push_back(loci[k].over_plane.cohesion.mean), plane.error.push_back(loci[k].over_plane.cohesion.error);
  }
  p.curves = {lid, plane};
  p.curves.push_back({"paper, simulation", {0.1, 2}, {paper_cohesion, paper_cohesion}, curve_style::dashed, {}, {}});
  p.curves.push_back(
      {"paper, experiment", {1, 2}, {experiment_cohesion, experiment_cohesion}, curve_style::dashed, {}, {}});
  pendular::io::draw(p, file);
}

}  // namespace

std::string stress_curves(const fs::path& folder, const fs::path& figures) {
  auto p = shear_plot("Shear stress at a normal stress of 300 Pa, w = 0 and 1 % (Fig. 5)");
  table t({"w (%)", "peak (Pa)", "at displacement (diameters)", "mean from 1 to 2 diameters (Pa)", "from 2 to 3 (Pa)",
           "drops of 2 % per diameter"});
  std::size_t colour = 0;
  for (const char* water : {"0", "0.01"}) {
    const seeds s = runs_of(folder / "stress_curves" / ("w" + std::string(water)));
    const std::string w = number("%g", 100 * std::stod(water));
    add(p, "w = " + w + " %, first seed", stress_curve(s.front()), colour);
    add(p, "mean of " + std::to_string(s.size()), mean_curve(s), colour++, curve_style::dashed);
    const measured drops = mean_of(each(s, [](const run& r) { return drops_per_diameter(r, 0.02); }));
    const measured at =
        mean_of(each(s, [](const run& r) { return r.number("strength", "displacement_at_peak_mean_diameters"); }));
    const auto mean = [&](double from, double to) {
      return in_pascal(mean_of(each(s, [&](const run& r) { return mean_between(stress_curve(r), from, to); })));
    };
    t.add({w, in_pascal(peak(s)), number("%.2f", at.mean, at.error), mean(1, 2), mean(2, 3),
           number("%.1f", drops.mean, drops.error)});
  }
  pendular::io::draw(p, figures / "fig05_shear_stress.png");
  return t.text();
}

std::string yield_loci(const fs::path& folder, const fs::path& figures) {
  std::vector<locus> loci;
  table t({"w (%)", "bridges per grain", "cohesion over lid stress (Pa)", "angle (degrees)",
           "cohesion over plane stress (Pa)", "angle (degrees)", "Rumpf (Pa)",
           "at the peak: cohesion over plane stress (Pa)", "angle (degrees)"});
  for (const char* water : waters) {
    const auto all = all_stresses(folder, water);
    const locus l = locus_of(all), top = locus_of(all, "peak_shear_stress_Pa");
    t.add({number("%g", 100 * std::stod(water)), number("%.2f", l.bridges.mean, l.bridges.error), cohesion(l.over_lid),
           angle(l.over_lid), cohesion(l.over_plane), angle(l.over_plane), expected_cohesion(l, all.front().front()),
           cohesion(top.over_plane), angle(top.over_plane)});
    loci.push_back(l);
  }
  draw_loci(loci, figures / "fig06a_yield_loci.png");
  draw_cohesion(loci, figures / "fig06b_cohesion.png");
  return t.text();
}

std::string bonds(const fs::path& folder, const fs::path& figures) {
  const seeds dry = sheared(folder, "0", "300"), full = sheared(folder, "0.01", "300");
  const seeds half = runs_of(folder / "thinned" / "t2_s300");
  auto p = shear_plot("Full and half the bonds at w = 1 %, 300 Pa, means of " + std::to_string(full.size()) +
                      " seeds (Fig. 7)");
  add(p, "all bonds", mean_curve(full), 0);
  add(p, "half the bonds", mean_curve(half), 1);
  add(p, "dry", mean_curve(dry), 2, curve_style::dashed);
  pendular::io::draw(p, figures / "fig07_bonds.png");
  p.title = "The same at small displacement (inset of Fig. 7)";
  p.x_range = {{0, 0.4}};
  pendular::io::draw(p, figures / "fig07_inset.png");

  table t({"bonds kept", "bridges per grain, start", "end", "over dry at 0.05 to 0.3 diameters (Pa)",
           "over dry at 1 to 2 diameters (Pa)", "cohesion from 300 and 800 Pa (Pa)"});
  const auto over_dry = [&](const seeds& low, double from, double to) {
    return in_pascal(mean_of(by_seed(low, dry, [&](const run& wet, const run& dry_one) {
      return mean_between(stress_curve(wet), from, to) - mean_between(stress_curve(dry_one), from, to);
    })));
  };
  const auto row = [&](const char* name, const seeds& low, const seeds& high) {
    const auto bridges = [&](const char* part, const char* key) {
      const measured m = mean_of(each(low, [&](const run& r) { return r.number(part, key); }));
      return number("%.2f", m.mean, m.error);
    };
    t.add({name, bridges("sample", "bridges_per_grain_start"), bridges("end", "bridges_per_grain"),
           over_dry(low, 0.05, 0.3), over_dry(low, 1, 2), cohesion(locus_of({low, high}).over_plane)});
  };
  row("all", full, sheared(folder, "0.01", "800"));
  row("half", half, runs_of(folder / "thinned" / "t2_s800"));
  row("a quarter", runs_of(folder / "thinned" / "t4_s300"), runs_of(folder / "thinned" / "t4_s800"));
  return t.text();
}

std::string grain_size(const fs::path& folder) {
  table t({"mean diameter (mm)", "dry angle (degrees)", "cohesion at w = 1 % (Pa)", "cohesion times diameter (N/m)"});
  for (const char* scale : {"0.5", "1", "2"}) {
    const auto at = [&](const char* water) {
      const auto runs = [&](const char* stress) {
        return runs_of(folder / "grain_size" / ("x" + std::string(scale) + "_w" + water + "_s" + stress));
      };
      return std::vector<seeds>{runs("300"), runs("800")};
    };
    const auto wet = at("0.01");
    const auto line = locus_of(wet).over_plane;
    const double diameter = wet.front().front().number("sample", "mean_diameter_m");
    t.add({number("%.3f", 1e3 * diameter), angle(locus_of(at("0")).over_plane), cohesion(line),
           number("%.3f", line.cohesion.mean * diameter, line.cohesion.error * diameter)});
  }
  return t.text();
}

std::string own_friction(const fs::path& folder, const fs::path& figures) {
  const fs::path own = folder / "own_friction";
  const seeds dry = runs_of(own / "shear_w0_s300"), wet = runs_of(own / "shear_w0.01_s300");
  auto p = shear_plot("Eq. 12 at 1e-6 s against the tangential spring, 300 Pa, means of " + std::to_string(wet.size()) +
                      " seeds");
  add(p, "w = 1 %, Eq. 12", mean_curve(wet), 0);
  add(p, "w = 1 %, spring", mean_curve(sheared(folder, "0.01", "300")), 0, curve_style::dashed);
  add(p, "dry, Eq. 12", mean_curve(dry), 1);
  add(p, "dry, spring", mean_curve(sheared(folder, "0", "300")), 1, curve_style::dashed);
  pendular::io::draw(p, figures / "fig05_own_friction.png");
  const auto line = locus_of({wet, runs_of(own / "shear_w0.01_s800")}).over_plane;
  table t({"friction of Eq. 12, γ_t = 1 N s/m", "peak (Pa)", "residual (Pa)", "cohesion over plane stress (Pa)"});
  t.add({"dry, 300 Pa", in_pascal(peak(dry)), in_pascal(residual(dry)), "-"});
  t.add({"w = 1 %, 300 Pa", in_pascal(peak(wet)), in_pascal(residual(wet)), cohesion(line)});
  return t.text();
}

}  // namespace paper::shear
