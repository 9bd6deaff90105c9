// SPDX-License-Identifier: BSD-3-Clause
#include "compression.hpp"

#include "../common/markdown.hpp"
#include "curves.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace paper::compression {

namespace {

namespace fs = std::filesystem;
using examples::markdown::number;
using examples::markdown::table;
using pendular::io::curve_style;

constexpr std::array waters{"0.02", "0.04", "0.06"};

double strength_of(const run& r) { return summit_of(stress_curve(r)).stress; }

measured ratio(const seeds& some, const seeds& others) {
  return mean_of(by_seed(some, others, [](const run& a, const run& b) { return strength_of(a) / strength_of(b); }));
}

measured of(const seeds& s, const char* part, const char* name, double unit = 1) {
  return mean_of(each(s, [&](const run& r) { return r.number(part, name) / unit; }));
}

std::string in_pascal(const measured& m) { return number("%.0f", m.mean, m.error); }

std::string with_hundredth(const measured& m) { return number("%.2f", m.mean, m.error); }

double percent(const char* water) { return 100 * std::stod(water); }

std::string in_percent(const char* water) { return number("%g", percent(water)); }

seeds with_own_friction(const fs::path& folder, const std::string& name) {
  return three_runs_of(folder / "own_friction" / ("compression_w" + name));
}

/// With "≥" where a curve still rises at its end.
std::string strength_in_pascal(const seeds& s) {
  bool rising = false;
  for (const run& r : s) rising = rising || summit_of(stress_curve(r)).rising;
  return (rising ? "≥ " : "") + in_pascal(mean_of(each(s, strength_of)));
}

std::string place_of_summit(const seeds& s) {
  return with_hundredth(mean_of(each(
      s, [](const run& r) { return summit_of(stress_curve(r)).at * r.number("sample", "mean_diameter_m") / 1e-3; })));
}

/// Eq. 12 at the paper's step and at the longer one of the other runs, where both have values.
std::string table_of_steps(const fs::path& folder) {
  table t({"friction, w = 2 %", "time step (s)", "mean stress from 0.1 to 0.25 diameters (Pa)"});
  const auto row = [&](const char* friction, const char* step, const seeds& s) {
    t.add({friction, step,
           in_pascal(mean_of(each(s, [](const run& r) { return mean_between(stress_curve(r), 0.1, 0.25); })))});
  };
  row("Eq. 12", "1e-6", with_own_friction(folder, "0.02_1e-6"));
  row("Eq. 12", "3.5e-6", with_own_friction(folder, "0.02"));
  row("tangential spring", "3.2e-5, 64 times the mass", three_runs_of(folder / "axial_stress" / "w0.02"));
  return t.text();
}

/// A way to share or to thin out the liquid, at several water contents.
struct way {
  const char* label;
  const char* group;
  std::string prefix;
  std::size_t count;  // of the water contents

  seeds runs(const fs::path& folder, std::size_t k) const {
    return three_runs_of(folder / group / (prefix + waters[k]));
  }
};
const std::array ways{
    way{"P1, homogeneous", "axial_stress", "w", 3}, way{"P2, kept on the grains", "protocols", "grain-films_w", 3},
    way{"P3, to the lowest contact", "protocols", "gravity_w", 3}, way{"P1, half the bonds", "half_bonds", "w", 2}};

std::vector<pendular::io::table> tables_of_relaxation(const seeds& s) {
  std::vector<pendular::io::table> tables;
  for (const run& r : s) tables.push_back(pendular::io::read_table(r.folder() / "relaxation.csv"));
  return tables;
}

/// A column of the last line that is not later. Errors: std::runtime_error if there is none.
measured at_time(const std::vector<pendular::io::table>& tables, double time, const char* name, double unit) {
  std::vector<double> values;
  for (const auto& t : tables) {
    const auto& times = t["time_s"];
    const auto after = std::upper_bound(times.begin(), times.end(), time * (1 + 1e-9));
    if (after == times.begin())
      throw std::runtime_error("a relaxation has no line up to " + std::to_string(time) + " s");
    values.push_back(t[name][static_cast<std::size_t>(after - times.begin()) - 1] / unit);
  }
  return mean_of(values);
}

void draw_settlement(const std::vector<pendular::io::table>& tables, const fs::path& file) {
  pendular::io::plot p;
  p.title = "Settlement without the mould, Eq. 12, w = 2 %, every seed";
  p.x_label = "time (s)";
  p.y_label = "settlement (mm)";
  for (const auto& [name, label] : {std::pair{"surface_settlement_m", "surface"}, {"centre_settlement_m", "centre"}}) {
    for (std::size_t k = 0; k < tables.size(); ++k) {
      std::vector<double> millimetres = tables[k][name];
      for (double& y : millimetres) y /= 1e-3;
      p.curves.push_back({k == 0 ? label : "",
                          tables[k]["time_s"],
                          millimetres,
                          curve_style::lines,
                          label == std::string("surface") ? 0u : 1u,
                          {}});
    }
  }
  pendular::io::draw(p, file);
}

}  // namespace

std::string stress_curves(const fs::path& folder, const fs::path& figures) {
  pendular::io::plot p;
  p.title = "Axial stress, means of three seeds; dashed: friction of Eq. 12 (Fig. 10)";
  p.x_label = "shortening over mean diameter";
  p.y_label = "axial stress (Pa)";
  table t({"w (%)", "strength (Pa)", "at shortening (mm)", "at 2 mm (Pa)", "bridges per grain, start",
           "contacts per grain, end", "strength with Eq. 12 (Pa)", "at shortening (mm)", "at its end (Pa)"});
  for (std::size_t k = 0; k < waters.size(); ++k) {
    const seeds s = ways.front().runs(folder, k), own = with_own_friction(folder, waters[k]);
    const xy curve = mean_curve(s), own_curve = mean_curve(own);
    p.curves.push_back({"w = " + in_percent(waters[k]) + " %", curve.x, curve.y, curve_style::lines, k, {}});
    p.curves.push_back({"", own_curve.x, own_curve.y, curve_style::dashed, k, {}});
    t.add({in_percent(waters[k]), strength_in_pascal(s), place_of_summit(s),
           in_pascal(of(s, "strength", "last_stress_Pa")), with_hundredth(of(s, "sample", "bridges_per_grain_relaxed")),
           with_hundredth(of(s, "coordination", "contacts_per_grain")), strength_in_pascal(own), place_of_summit(own),
           in_pascal(of(own, "strength", "last_stress_Pa"))});
  }
  pendular::io::draw(p, figures / "fig10_axial_stress.png");
  return t.text() + "\n" + table_of_steps(folder);
}

std::string strengths(const fs::path& folder, const fs::path& figures) {
  pendular::io::plot p;
  p.title = "Compressive strength against water content (Fig. 12)";
  p.x_label = "water content (%)";
  p.y_label = "compressive strength (Pa)";
  p.x_range = {{1.5, 6.5}};
  p.y_range = {{0, 600}};
  table t({"bonds", "w (%)", "strength (Pa)", "over P1", "bridges per grain, start", "largest V_b/R³",
           "unbalanced force ratio, start"});
  for (const way& each_way : ways) {
    pendular::io::curve c{each_way.label, {}, {}, curve_style::linespoints, {}, {}};
    for (std::size_t k = 0; k < each_way.count; ++k) {
      const seeds s = each_way.runs(folder, k);
      const measured found = mean_of(each(s, strength_of)), over = ratio(s, ways.front().runs(folder, k));
      t.add({c.label, in_percent(waters[k]), strength_in_pascal(s), with_hundredth(over),
             with_hundredth(of(s, "sample", "bridges_per_grain_relaxed")),
             with_hundredth(of(s, "liquid", "largest_bridge_over_R3")),
             number("%.0e", of(s, "sample", "unbalanced_force_ratio").mean)});
      c.x.push_back(percent(waters[k])), c.y.push_back(found.mean), c.error.push_back(found.error);
    }
    p.curves.push_back(c);
  }
  pendular::io::draw(p, figures / "fig12_strength.png");
  return t.text();
}

std::string still_zone(const fs::path& folder, const fs::path& figures) {
  const seeds s = ways.front().runs(folder, 0);
  for (const char* picture : {"section", "sample"}) {
    const fs::path from = s.front().folder() / (std::string(picture) + ".png");
    if (fs::exists(from)) {
      fs::copy_file(from, figures / ("fig11_" + std::string(picture) + ".png"), fs::copy_options::overwrite_existing);
    }
  }
  table t({"fifth of the height, from the floor", "share of grains moved by less than 0.2 mm (%)",
           "radius that holds nine tenths of them (mm)"});
  for (std::size_t k = 0; k < 5; ++k) {
    const auto entry = [&](const char* name, double unit) {
      return mean_of(each(s, [&](const run& r) { return r.number("still_grains", name, k) / unit; }));
    };
    const measured share = entry("share_by_fifth_of_height", 0.01), radius = entry("radius_by_fifth_m", 1e-3);
    t.add({std::to_string(k + 1), number("%.1f", share.mean, share.error), number("%.1f", radius.mean, radius.error)});
  }
  return t.text();
}

std::string relaxation(const fs::path& folder) {
  table t({"w = 2 %", "strength (Pa)", "settlement of the surface (mm)", "of the centre (mm)",
           "bridges per grain, start", "unbalanced force ratio"});
  const auto row = [&](const char* label, const fs::path& of_case) {
    const seeds s = three_runs_of(folder / of_case);
    const measured surface = of(s, "sample", "surface_settlement_m", 1e-3),
                   centre = of(s, "sample", "centre_settlement_m", 1e-3);
    t.add({label, strength_in_pascal(s), number("%.4f", surface.mean, surface.error),
           number("%.4f", centre.mean, centre.error), with_hundredth(of(s, "sample", "bridges_per_grain_relaxed")),
           number("%.0e", of(s, "sample", "unbalanced_force_ratio").mean)});
  };
  row("all bonds, relaxed", "axial_stress/w0.02");
  row("not relaxed", "not_relaxed/w0.02");
  row("half the bonds, relaxed", "half_bonds/w0.02");
  row("not relaxed", "not_relaxed/half_bonds_w0.02");
  return t.text();
}

std::string settlement(const fs::path& folder, const fs::path& figures) {
  const seeds settled = three_runs_of(folder / "settled" / "w0.02");
  const auto lines = tables_of_relaxation(settled);
  table course(
      {"time without the mould (s)", "settlement of the surface (mm)", "of the centre (mm)", "bridges per grain"});
  for (const double time : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0}) {
    const measured surface = at_time(lines, time, "surface_settlement_m", 1e-3),
                   centre = at_time(lines, time, "centre_settlement_m", 1e-3);
    course.add({number("%g", time), number("%.4f", surface.mean, surface.error),
                number("%.4f", centre.mean, centre.error),
                with_hundredth(at_time(lines, time, "bridges_per_grain", 1))});
  }
  draw_settlement(lines, figures / "settlement.png");
  table strengths(
      {"Eq. 12, w = 2 %", "strength (Pa)", "at shortening (mm)", "bridges per grain, start", "unbalanced force ratio"});
  const auto row = [&](const char* label, const seeds& s) {
    strengths.add({label, strength_in_pascal(s), place_of_summit(s),
                   with_hundredth(of(s, "sample", "bridges_per_grain_relaxed")),
                   number("%.0e", of(s, "sample", "unbalanced_force_ratio").mean)});
  };
  row("after 0.03 s", with_own_friction(folder, "0.02"));
  row("after 3 s", settled);
  return course.text() + "\n" + strengths.text();
}

std::string wet_pairs(const fs::path& folder) {
  table t({"wet pairs", "w (%)", "strength (Pa)", "over all eligible pairs", "bridges per grain, as distributed",
           "start of the test"});
  for (std::size_t k = 0; k < waters.size(); ++k) {
    const seeds all = ways.front().runs(folder, k),
                touching = three_runs_of(folder / "wet_pairs" / ("touching_w" + std::string(waters[k])));
    const auto row = [&](const char* label, const seeds& s) {
      t.add({label, in_percent(waters[k]), strength_in_pascal(s), with_hundredth(ratio(s, all)),
             with_hundredth(of(s, "sample", "bridges_per_grain_initial")),
             with_hundredth(of(s, "sample", "bridges_per_grain_relaxed"))});
    };
    row("eligible", all), row("touching", touching);
  }
  return t.text();
}

}  // namespace paper::compression
