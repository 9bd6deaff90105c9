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

std::string in_degrees(const measured& m) { return number("%.1f", m.mean, m.error); }

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
  return number("%.0f", l.tan_friction().mean * l.bridges.mean * capillary_pressure_per_bridge(fraction, kappa));
}

void draw_loci(const std::vector<locus>& loci, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Yield loci in direct shear, all seeds, mean of their lines (Fig. 6a)";
  p.x_label = "normal stress of the lid (Pa)";
  p.y_label = "residual shear stress (Pa)";
  p.x_range = {{0, 900}};
  p.y_range = {{0, 900}};
  for (std::size_t k = 0; k < loci.size(); ++k) {
    const double cohesion = loci[k].intercept().mean, tangent = loci[k].tan_friction().mean;
    p.curves.push_back({"w = " + number("%g", 100 * std::stod(waters[k])) + " %",
                        loci[k].lid,
                        loci[k].shear,
                        curve_style::points,
                        k,
                        {}});
    p.curves.push_back({"", {0, 900}, {cohesion, cohesion + 900 * tangent}, curve_style::lines, k, {}});
  }
  pendular::io::draw(p, file);
}

/// What liquid adds over the water content, the dry locus being the first.
template <class Added>
pendular::io::curve cohesion_curve(const std::string& label, const std::vector<locus>& loci, const Added& added) {
  pendular::io::curve c{label, {}, {}, curve_style::linespoints, {}, {}};
  for (std::size_t k = 0; k < loci.size(); ++k) {
    const measured m = added(loci[k], loci.front());
    c.x.push_back(100 * std::stod(waters[k])), c.y.push_back(m.mean), c.error.push_back(m.error);
  }
  return c;
}

void draw_cohesion(const std::vector<locus>& loci, const std::vector<locus>& peaks, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Coulomb cohesion against water content (Fig. 6b)";
  p.x_label = "water content (%)";
  p.y_label = "cohesion (Pa)";
  p.x_range = {{-0.05, 2.1}};
  p.curves = {cohesion_curve("intercept of the line less that of the dry sample", loci, added_intercept),
              cohesion_curve("shear stress less that of the dry sample", loci, added_shear_stress),
              cohesion_curve("the same at the peak", peaks, added_shear_stress)};
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
  std::vector<locus> loci, peaks;
  table t({"w (%)", "bridges per grain", "intercept (Pa)", "angle (degrees)", "angle over plane stress (degrees)",
           "intercept less dry (Pa)", "shear stress less dry (Pa)", "Rumpf (Pa)", "at the peak: less dry (Pa)"});
  for (const char* water : waters) {
    const auto all = all_stresses(folder, water);
    loci.push_back(locus_of(all));
    peaks.push_back(locus_of(all, "peak_shear_stress_Pa"));
    const locus &l = loci.back(), &dry = loci.front();
    t.add({number("%g", 100 * std::stod(water)), number("%.2f", l.bridges.mean, l.bridges.error),
           in_pascal(l.intercept()), in_degrees(l.lid_angle()), in_degrees(l.plane_angle()),
           in_pascal(added_intercept(l, dry)), in_pascal(added_shear_stress(l, dry)),
           expected_cohesion(l, all.front().front()), in_pascal(added_shear_stress(peaks.back(), peaks.front()))});
  }
  draw_loci(loci, figures / "fig06a_yield_loci.png");
  draw_cohesion(loci, peaks, figures / "fig06b_cohesion.png");
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
           "over dry at 1 to 2 diameters (Pa)", "the same, mean of 300 and 800 Pa (Pa)"});
  const locus dry_locus = locus_of({dry, sheared(folder, "0", "800")});
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
           over_dry(low, 0.05, 0.3), over_dry(low, 1, 2),
           in_pascal(added_shear_stress(locus_of({low, high}), dry_locus))});
  };
  row("all", full, sheared(folder, "0.01", "800"));
  row("half", half, runs_of(folder / "thinned" / "t2_s800"));
  row("a quarter", runs_of(folder / "thinned" / "t4_s300"), runs_of(folder / "thinned" / "t4_s800"));
  return t.text();
}

std::string grain_size(const fs::path& folder) {
  table t({"mean diameter (mm)", "angle, dry (degrees)", "wet", "shear stress less dry, w = 1 % (Pa)",
           "times the diameter (N/m)"});
  for (const char* scale : {"0.5", "1", "2"}) {
    const auto at = [&](const char* water) {
      const auto runs = [&](const char* stress) {
        return runs_of(folder / "grain_size" / ("x" + std::string(scale) + "_w" + water + "_s" + stress));
      };
      return std::vector<seeds>{runs("300"), runs("800")};
    };
    const auto wet_runs = at("0.01");
    const locus wet = locus_of(wet_runs), dry = locus_of(at("0"));
    const measured cohesion = added_shear_stress(wet, dry);
    const double diameter = wet_runs.front().front().number("sample", "mean_diameter_m");
    t.add({number("%.3f", 1e3 * diameter), in_degrees(dry.lid_angle()), in_degrees(wet.lid_angle()),
           in_pascal(cohesion), number("%.3f", cohesion.mean * diameter, cohesion.error * diameter)});
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
  const locus line = locus_of({wet, runs_of(own / "shear_w0.01_s800")});
  const measured cohesion = mean_of(by_seed(wet, dry, [](const run& a, const run& b) {
    return a.number("strength", "residual_shear_stress_Pa") - b.number("strength", "residual_shear_stress_Pa");
  }));
  table t({"friction of Eq. 12, γ_t = 1 N s/m", "peak (Pa)", "residual (Pa)", "less dry (Pa)", "angle (degrees)"});
  t.add({"dry, 300 Pa", in_pascal(peak(dry)), in_pascal(residual(dry)), "-", "-"});
  t.add({"w = 1 %, 300 Pa", in_pascal(peak(wet)), in_pascal(residual(wet)), in_pascal(cohesion),
         in_degrees(line.lid_angle())});
  return t.text();
}

}  // namespace paper::shear
