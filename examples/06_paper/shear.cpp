// SPDX-License-Identifier: BSD-3-Clause
#include "shear.hpp"

#include "../common/markdown.hpp"
#include "cohesion.hpp"
#include "curves.hpp"
#include "loci.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>

#include <string>
#include <utility>
#include <vector>

namespace paper::shear {

namespace {

namespace fs = std::filesystem;
using examples::markdown::number;
using examples::markdown::table;
using pendular::io::curve_style;

seeds sheared(const fs::path& folder, const std::string& water, const std::string& stress) {
  return three_runs_of(folder / "yield_loci" / ("w" + water + "_s" + stress));
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

std::string in_pascal(const measured& m) { return number("%.0f", m.mean, m.error); }

std::string with_tenth(const measured& m) { return number("%.1f", m.mean, m.error); }

measured mean_stress(const seeds& s, double from, double to) {
  return mean_of(each(s, [&](const run& r) { return mean_between(stress_curve(r), from, to); }));
}

measured falls(const seeds& s, double least) {
  return mean_of(each(s, [&](const run& r) { return falls_per_diameter(r, least); }));
}

measured peak(const seeds& s) {
  return mean_of(each(s, [](const run& r) { return summit_of(stress_curve(r)).stress; }));
}

measured place_of_peak(const seeds& s) {
  return mean_of(each(s, [](const run& r) { return summit_of(stress_curve(r)).at; }));
}

/// Shear stress of wet samples less that of dry ones, run by run.
measured over_dry(const seeds& wet, const seeds& dry, double from, double to) {
  return mean_of(by_seed(wet, dry, [&](const run& w, const run& d) {
    return mean_between(stress_curve(w), from, to) - mean_between(stress_curve(d), from, to);
  }));
}

void draw_bonds(const seeds& full, const seeds& half, const seeds& dry, const fs::path& figures) {
  auto p = shear_plot("Full and half the bonds at w = 1 %, 300 Pa, means of three seeds (Fig. 7)");
  add(p, "all bonds", mean_curve(full), 0);
  add(p, "half the bonds", mean_curve(half), 1);
  add(p, "dry", mean_curve(dry), 2, curve_style::dashed);
  pendular::io::draw(p, figures / "fig07_bonds.png");
  p.title = "The same at small displacement (inset of Fig. 7)";
  p.x_range = {{0, 0.4}};
  pendular::io::draw(p, figures / "fig07_inset.png");
}

/// A row of the table of Fig. 7, from samples under 300 and under 800 Pa.
void add_bonds(table& t, const char* name, const seeds& low, const seeds& high, const seeds& dry,
               const locus& dry_locus) {
  const locus l = locus_of({low, high});
  const measured start = mean_of(each(low, [](const run& r) { return r.number("sample", "bridges_per_grain_start"); }));
  t.add({name, number("%.2f", start.mean, start.error), number("%.2f", l.bridges().mean, l.bridges().error),
         in_pascal(over_dry(low, dry, 0.05, 0.3)), in_pascal(over_dry(low, dry, 1, 2)),
         in_pascal(mean_of(beyond_dry_line(l, dry_locus))), in_pascal(expected_cohesion(l, low.front()))});
}

/// Relative change from one stretch of two diameters to the next of what is taken from its state, %.
template <class Value>
std::string decline(const seeds& s, const Value& value) {
  return with_tenth(mean_of(each(
      s, [&](const run& r) { return 100 * (value(state_between(r, 2, 3)) / value(state_between(r, 1, 2)) - 1); })));
}

/// What becomes of the stress beyond the residual state, over the cell and over what the halves still share.
std::string table_of_decline(const std::vector<std::pair<std::string, seeds>>& samples) {
  table t({"w (%)", "shear stress (%)", "shared area (%)", "shear stress over the shared area (%)",
           "normal stress over the shared area (%)", "lid rises (mm)"});
  for (const auto& [water, s] : samples) {
    const measured rise = mean_of(
        each(s, [](const run& r) { return (state_between(r, 2, 3).height - state_between(r, 1, 2).height) / 1e-3; }));
    t.add({water, decline(s, [](const shear_state& a) { return a.shear; }),
           decline(s, [](const shear_state& a) { return a.shared; }),
           decline(s, [](const shear_state& a) { return a.shear / a.shared; }),
           decline(s, [](const shear_state& a) { return a.normal / a.shared; }),
           number("%.3f", rise.mean, rise.error)});
  }
  return t.text();
}

}  // namespace

std::string stress_curves(const fs::path& folder, const fs::path& figures) {
  auto p = shear_plot("Shear stress at a normal stress of 300 Pa, w = 0 and 1 % (Fig. 5)");
  table t({"w (%)", "peak (Pa)", "at displacement (diameters)", "peak over residual", "mean from 1 to 2 diameters (Pa)",
           "from 2 to 3 (Pa)", "falls by 5 Pa per diameter", "by 15 Pa"});
  std::vector<std::pair<std::string, seeds>> samples;
  for (const std::string water : {"0", "0.01"}) {
    const seeds s = three_runs_of(folder / "true_mass" / ("w" + water + "_s300"));
    const std::string w = number("%g", 100 * std::stod(water));
    add(p, "w = " + w + " %, first seed", stress_curve(s.front()), samples.size());
    add(p, "mean of three", mean_curve(s), samples.size(), curve_style::dashed);
    const measured at = place_of_peak(s), over = mean_of(each(s, summit_over_residual));
    t.add({w, in_pascal(peak(s)), number("%.2f", at.mean, at.error), number("%.2f", over.mean, over.error),
           in_pascal(mean_stress(s, 1, 2)), in_pascal(mean_stress(s, 2, 3)), with_tenth(falls(s, 5)),
           with_tenth(falls(s, 15))});
    samples.emplace_back(w, s);
  }
  pendular::io::draw(p, figures / "fig05_shear_stress.png");
  return t.text() + "\n" + table_of_decline(samples);
}

std::string bonds(const fs::path& folder, const fs::path& figures) {
  const auto thinned = [&](const char* name) { return three_runs_of(folder / "thinned" / name); };
  const seeds dry = sheared(folder, "0", "300"), full = sheared(folder, "0.01", "300"), half = thinned("t2_s300");
  draw_bonds(full, half, dry, figures);
  table t({"bonds kept", "bridges per grain, start", "from 1 to 2 diameters", "over dry at 0.05 to 0.3 diameters (Pa)",
           "over dry at 1 to 2 diameters (Pa)", "beyond the dry line, 300 and 800 Pa (Pa)", "Rumpf (Pa)"});
  const locus dry_locus = locus_of({dry, sheared(folder, "0", "800")});
  add_bonds(t, "all", full, sheared(folder, "0.01", "800"), dry, dry_locus);
  add_bonds(t, "half", half, thinned("t2_s800"), dry, dry_locus);
  add_bonds(t, "a quarter", thinned("t4_s300"), thinned("t4_s800"), dry, dry_locus);
  return t.text();
}

}  // namespace paper::shear
