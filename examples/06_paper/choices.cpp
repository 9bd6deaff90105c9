// SPDX-License-Identifier: BSD-3-Clause
#include "choices.hpp"

#include "../common/markdown.hpp"
#include "curves.hpp"
#include "loci.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace paper::shear {

namespace {

namespace fs = std::filesystem;
using examples::markdown::number;
using examples::markdown::table;
using pendular::io::curve_style;

constexpr const char* usual_density = "looser";

struct way {
  const char* density;  // the folder of its jobs
  const char* label;
  const char* high = "800";  // the larger of its two loads, Pa
};
constexpr std::array ways{way{"dense", "without friction, to 0.60"}, way{"consolidated", "with 0.4, to 0.60"},
                          way{"looser", "with 0.4, to 0.57"}, way{"as_deposited", "with 0.4, not consolidated", "550"}};

struct law {
  const char* name;  // in the folders of its jobs
  const char* label;
};
constexpr std::array laws{law{"viscous", "Eq. 12"}, law{"spring", "spring"}};

/// Dry and wet samples under 300 Pa and a larger load.
struct group {
  seeds dry, wet, dry_high, wet_high;

  locus dry_locus() const { return locus_of({dry, dry_high}); }
  locus wet_locus() const { return locus_of({wet, wet_high}); }
};

/// `prefix` comes before w<water>_s<load> in the names of the cases.
group group_of(const fs::path& folder, const std::string& prefix, const std::string& high = "800") {
  const auto runs = [&](const std::string& name) { return three_runs_of(folder / (prefix + name)); };
  return {runs("w0_s300"), runs("w0.01_s300"), runs("w0_s" + high), runs("w0.01_s" + high)};
}

group usual(const fs::path& folder) { return group_of(folder / "yield_loci", ""); }

group group_of(const fs::path& folder, const way& w, const law& l) {
  if (w.density == std::string(usual_density) && l.name == std::string("viscous")) return usual(folder);
  return group_of(folder / "choices" / w.density, l.name + std::string("_"), w.high);
}

measured of_sample(const seeds& s, const char* name) {
  return mean_of(each(s, [&](const run& r) { return r.number("sample", name); }));
}

std::string with(const char* format, const measured& m) { return number(format, m.mean, m.error); }

std::string peak_over_residual(const seeds& s) { return with("%.2f", mean_of(each(s, summit_over_residual))); }

std::string place_of_peak(const seeds& s) {
  return with("%.2f", mean_of(each(s, [](const run& r) { return summit_of(stress_curve(r)).at; })));
}

std::string falls(const seeds& s, double least) {
  return with("%.1f", mean_of(each(s, [&](const run& r) { return falls_per_diameter(r, least); })));
}

std::string rise_of_lid(const seeds& s) {
  return with("%.2f", mean_of(each(s, [](const run& r) {
                return (state_between(r, 1.9, 2).height - r.number("sample", "start_height_m")) / 1e-3;
              })));
}

std::string residual(const seeds& s) {
  return with("%.0f", mean_of(each(s, [](const run& r) { return residual_state(r).shear; })));
}

/// Angles and intercepts of the dry and of the wet line, and what the wet samples bear beyond the dry line.
std::vector<std::string> lines_of(const group& g) {
  const locus dry = g.dry_locus(), wet = g.wet_locus();
  return {with("%.1f", dry.angle()), with("%.1f", wet.angle()), with("%.0f", dry.cohesion()),
          with("%.0f", wet.cohesion()), with("%.0f", mean_of(beyond_dry_line(wet, dry)))};
}

/// Solid fractions at the start, and whether there is a peak under 300 Pa.
std::vector<std::string> state_of(const group& g) {
  std::vector<std::string> cells;
  for (const char* name : {"solid_fraction_start", "solid_fraction_bulk", "solid_fraction_near_walls"}) {
    cells.push_back(with("%.3f", of_sample(g.wet, name)));
  }
  for (const seeds* s : {&g.dry, &g.wet}) {
    cells.push_back(with("%.2f", mean_of(each(*s, early_over_residual))));
    cells.push_back(peak_over_residual(*s));
    cells.push_back(place_of_peak(*s));
  }
  return cells;
}

void add(table& t, std::vector<std::string> cells, const std::vector<std::string>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
  t.add(cells);
}

void draw(const fs::path& folder, const fs::path& figures, const char* what, seeds group::*member) {
  pendular::io::plot p;
  p.title = std::string("Shear stress, ") + what + ", 300 Pa, means of three seeds; dashed: spring";
  p.x_label = "displacement over mean diameter";
  p.y_label = "shear stress (Pa)";
  p.x_range = {{0, 2}};
  p.y_range = {{0, 500}};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    for (const law& l : laws) {
      const bool spring = l.name == std::string("spring");
      const xy c = mean_curve(group_of(folder, ways[k], l).*member);
      p.curves.push_back(
          {spring ? "" : ways[k].label, c.x, c.y, spring ? curve_style::dashed : curve_style::lines, k, {}});
    }
  }
  pendular::io::draw(p, figures / ("fig05_choices_" + std::string(what) + ".png"));
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Of the processor, for two diameters of displacement at the usual speed, s.
double run_time(const seeds& s) {
  return median(each(s, [](const run& r) {
    return r.number("cost", "processor_s_per_step") * 3.3e-3 / 5e-3 / r.numeric_option("time-step");
  }));
}

/// Of the residual stress of wet samples, seed by seed, %.
std::string change_from(const seeds& finest, const seeds& s) {
  const double whole = mean_of(each(finest, [](const run& r) { return residual_state(r).shear; })).mean;
  const measured m = mean_of(by_seed(s, finest, [&](const run& a, const run& b) {
    return 100 * (residual_state(a).shear - residual_state(b).shear) / whole;
  }));
  return with("%+.1f", m);
}

}  // namespace

std::string choices(const fs::path& folder, const fs::path& figures) {
  table states({"deposit and consolidation", "friction", "solid fraction, cell", "bulk", "near walls",
                "dry: 0.4 to 0.8 diameters over residual", "peak over residual", "at (diameters)",
                "wet: 0.4 to 0.8 diameters over residual", "peak over residual", "at (diameters)"});
  table lines({"deposit and consolidation", "friction", "angle, dry (degrees)", "wet", "intercept, dry (Pa)",
               "wet (Pa)", "wet beyond the dry line (Pa)", "falls by 5 Pa per diameter, dry", "wet", "by 15 Pa, dry",
               "wet", "lid rises in two diameters, dry (mm)", "wet (mm)"});
  for (const way& w : ways) {
    for (const law& l : laws) {
      const group g = group_of(folder, w, l);
      add(states, {w.label, l.label}, state_of(g));
      std::vector<std::string> cells = lines_of(g);
      for (const double least : {5.0, 15.0}) {
        for (const seeds* s : {&g.dry, &g.wet}) cells.push_back(falls(*s, least));
      }
      for (const seeds* s : {&g.dry, &g.wet}) cells.push_back(rise_of_lid(*s));
      add(lines, {w.label, l.label}, cells);
    }
  }
  draw(folder, figures, "dry", &group::dry);
  draw(folder, figures, "wet", &group::wet);
  return states.text() + "\n" + lines.text();
}

std::string speeds(const fs::path& folder) {
  table t({"speed (mm/s)", "dry, 300 Pa (Pa)", "wet, 300 Pa (Pa)", "angle, dry (degrees)", "wet", "intercept, dry (Pa)",
           "wet (Pa)", "wet beyond the dry line (Pa)"});
  const auto row = [&](const char* speed, const group& g) {
    add(t, {speed, residual(g.dry), residual(g.wet)}, lines_of(g));
  };
  row("5", usual(folder));
  row("10", group_of(folder / "speed", "v10e-3_"));
  return t.text();
}

std::string settings(const fs::path& folder) {
  table t({"time step (s)", "mass", "wet, 300 Pa (Pa)", "change from the first (%)", "peak over residual",
           "angle, wet (degrees)", "intercept, dry (Pa)", "wet (Pa)", "wet beyond the dry line (Pa)",
           "falls by 5 Pa per diameter, dry", "wet", "time of a run (s)"});
  const seeds finest = three_runs_of(folder / "paper_step" / "w0.01_s300");
  const auto seconds = [](const seeds& s) { return number("%.0f", run_time(s)); };
  t.add({"1e-6", "1", residual(finest), "", peak_over_residual(finest), "", "", "", "", "", falls(finest, 5),
         seconds(finest)});
  const auto row = [&](const char* step, const char* mass, const group& g) {
    const auto lines = lines_of(g);
    t.add({step, mass, residual(g.wet), change_from(finest, g.wet), peak_over_residual(g.wet), lines[1], lines[2],
           lines[3], lines[4], falls(g.dry, 5), falls(g.wet, 5), seconds(g.wet)});
  };
  row("3.5e-6", "1", group_of(folder / "true_mass", ""));
  row("1.4e-5", "16", usual(folder));
  return t.text();
}

namespace {
/// Rows of wet samples under 300 and 800 Pa, each with its line and what it bears beyond the dry one.
class wet_table {
 public:
  wet_table(const char* what, const locus& dry)
      : dry_(dry), table_({what, "bridges per grain, start", "from 1 to 2 diameters", "wet, 300 Pa (Pa)",
                           "angle (degrees)", "intercept (Pa)", "beyond the dry line (Pa)"}) {}

  void add(const char* label, const seeds& low, const seeds& high) {
    const locus wet = locus_of({low, high});
    table_.add({label, with("%.2f", of_sample(low, "bridges_per_grain_start")), with("%.2f", wet.bridges()),
                residual(low), with("%.1f", wet.angle()), with("%.0f", wet.cohesion()),
                with("%.0f", mean_of(beyond_dry_line(wet, dry_)))});
  }
  void add(const char* label, const fs::path& of_case) {
    add(label, three_runs_of(of_case.string() + "_s300"), three_runs_of(of_case.string() + "_s800"));
  }
  std::string text() const { return table_.text(); }

 private:
  locus dry_;
  table table_;
};
}  // namespace

std::string wet_pairs(const fs::path& folder) {
  const group all = usual(folder);
  wet_table t("wet pairs", all.dry_locus());
  t.add("eligible", all.wet, all.wet_high);
  t.add("touching", folder / "wet_pairs" / "touching");
  return t.text();
}

std::string protocols(const fs::path& folder) {
  const group all = usual(folder);
  wet_table t("liquid", all.dry_locus());
  t.add("w = 1 %, P2, kept on the grains", all.wet, all.wet_high);
  t.add("w = 1 %, P1, homogeneous", folder / "protocols_in_shear" / "homogeneous");
  t.add("w = 1 %, P3, to the lowest contact", folder / "protocols_in_shear" / "gravity");
  t.add("w = 0.05 %", folder / "yield_loci" / "w0.0005");
  t.add("w = 1 %, as many bonds", folder / "same_bonds" / "t1.2");
  return t.text();
}

}  // namespace paper::shear
