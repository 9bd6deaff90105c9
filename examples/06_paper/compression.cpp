// SPDX-License-Identifier: BSD-3-Clause
#include "compression.hpp"

#include "../common/markdown.hpp"
#include "curves.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>

#include <array>

namespace paper::compression {

namespace {

namespace fs = std::filesystem;
using examples::markdown::number;
using examples::markdown::table;
using pendular::io::curve_style;

constexpr std::array waters{"0.02", "0.04", "0.06"};

measured strength(const seeds& s) {
  return mean_of(each(s, [](const run& r) { return r.number("strength", "peak_stress_Pa"); }));
}

measured of(const seeds& s, const char* part, const char* name, double unit = 1) {
  return mean_of(each(s, [&](const run& r) { return r.number(part, name) / unit; }));
}

std::string in_pascal(const measured& m) { return number("%.0f", m.mean, m.error); }

double percent(const char* water) { return 100 * std::stod(water); }

/// A way to share or to thin out the liquid, at several water contents.
struct way {
  const char* label;
  const char* group;
  std::string prefix;
  std::size_t count;  // of the water contents
};
const std::array ways{
    way{"P1, homogeneous", "axial_stress", "w", 3}, way{"P2, kept on the grains", "protocols", "grain-films_w", 3},
    way{"P3, to the lowest contact", "protocols", "gravity_w", 3}, way{"P1, half the bonds", "half_bonds", "w", 2}};

}  // namespace

std::string stress_curves(const fs::path& folder, const fs::path& figures) {
  pendular::io::plot p;
  p.title = "Axial stress, means of all seeds; dashed: Eq. 12 at 1e-6 s (Fig. 10)";
  p.x_label = "shortening over mean diameter";
  p.y_label = "axial stress (Pa)";
  table t({"w (%)", "strength (Pa)", "at shortening (mm)", "at 2 mm (Pa)", "with Eq. 12 (Pa)", "bridges per grain",
           "contacts per grain, end"});
  for (std::size_t k = 0; k < waters.size(); ++k) {
    const seeds s = runs_of(folder / "axial_stress" / ("w" + std::string(waters[k])));
    const seeds own = runs_of(folder / "own_friction" / ("compression_w" + std::string(waters[k])));
    const auto add = [&](const std::string& label, const xy& c, curve_style style) {
      p.curves.push_back({label, c.x, c.y, style, k, {}});
    };
    add("w = " + number("%g", percent(waters[k])) + " %", mean_curve(s), curve_style::lines);
    add("", mean_curve(own), curve_style::dashed);
    const measured at = of(s, "strength", "shortening_at_peak_m", 1e-3),
                   bridges = of(s, "sample", "bridges_per_grain_relaxed"),
                   contacts = of(s, "coordination", "contacts_per_grain");
    t.add({number("%g", percent(waters[k])), in_pascal(strength(s)), number("%.2f", at.mean, at.error),
           in_pascal(of(s, "strength", "last_stress_Pa")), in_pascal(strength(own)),
           number("%.2f", bridges.mean, bridges.error), number("%.2f", contacts.mean, contacts.error)});
  }
  pendular::io::draw(p, figures / "fig10_axial_stress.png");
  return t.text();
}

std::string strengths(const fs::path& folder, const fs::path& figures) {
  pendular::io::plot p;
  p.title = "Compressive strength against water content (Fig. 12)";
  p.x_label = "water content (%)";
  p.y_label = "compressive strength (Pa)";
  p.x_range = {{1.5, 6.5}};
  table t({"bonds", "w (%)", "strength (Pa)", "over P1", "bridges per grain at the start"});
  std::array<seeds, waters.size()> base;
  for (const way& each_way : ways) {
    pendular::io::curve c{each_way.label, {}, {}, curve_style::linespoints, {}, {}};
    for (std::size_t k = 0; k < each_way.count; ++k) {
      const seeds s = runs_of(folder / each_way.group / (each_way.prefix + waters[k]));
      const measured found = strength(s), bridges = of(s, "sample", "bridges_per_grain_relaxed");
      if (c.label == ways.front().label) base[k] = s;
      const measured over = mean_of(by_seed(s, base[k], [](const run& a, const run& b) {
        return a.number("strength", "peak_stress_Pa") / b.number("strength", "peak_stress_Pa");
      }));
      t.add({c.label, number("%g", percent(waters[k])), in_pascal(found), number("%.3f", over.mean, over.error),
             number("%.2f", bridges.mean, bridges.error)});
      c.x.push_back(percent(waters[k])), c.y.push_back(found.mean), c.error.push_back(found.error);
    }
    p.curves.push_back(c);
  }
  pendular::io::draw(p, figures / "fig12_strength.png");
  return t.text();
}

std::string still_zone(const fs::path& folder, const fs::path& figures) {
  const seeds s = runs_of(folder / "axial_stress" / "w0.02");
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
           "bridges per grain at the start", "unbalanced force ratio"});
  const auto row = [&](const char* label, const seeds& s) {
    const measured surface = of(s, "sample", "surface_settlement_m", 1e-3),
                   centre = of(s, "sample", "centre_settlement_m", 1e-3),
                   unrest = of(s, "sample", "unbalanced_force_ratio"),
                   bridges = of(s, "sample", "bridges_per_grain_relaxed");
    t.add({label, in_pascal(strength(s)), number("%.4f", surface.mean, surface.error),
           number("%.4f", centre.mean, centre.error), number("%.2f", bridges.mean, bridges.error),
           number("%.1e", unrest.mean)});
  };
  row("relaxed for 0.2 s", runs_of(folder / "axial_stress" / "w0.02"));
  row("not relaxed", runs_of(folder / "not_relaxed" / "w0.02"));
  return t.text();
}

}  // namespace paper::compression
