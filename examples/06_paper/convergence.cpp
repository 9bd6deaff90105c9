// SPDX-License-Identifier: BSD-3-Clause
#include "convergence.hpp"

#include "../common/markdown.hpp"
#include "curves.hpp"
#include "run.hpp"

#include <pendular/io/plot.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace paper::convergence {

namespace {

using examples::markdown::number;

enum class finest { smallest, largest };

/// What is finer than every value of a series.
enum class beyond { nothing, finest_step, reference };

/// What is varied: an option of the jobs.
struct series {
  const char* test;  // or both
  const char* name;
  const char* title;
  const char* option;
  finest best;
  bool with_reference;
  bool own_packings;  // not those of the reference: nothing is shared between runs of the same seed
  beyond finer = beyond::nothing;
};

constexpr std::array all_series{
    series{"both", "time_step", "time step (s)", "time-step", finest::smallest, true, false},
    series{"both", "mass_scaling", "mass scaling", "mass-scaling", finest::smallest, true, false, beyond::finest_step},
    series{"shear", "shear_speed", "speed (m/s)", "shear-speed", finest::smallest, true, false},
    series{"compression", "wall_speed", "speed (m/s)", "wall-speed", finest::smallest, true, false},
    series{"both", "stiffness", "k_n (N/m)", "stiffness", finest::largest, false, true},
    series{"both", "grains", "grains", "grains", finest::largest, true, true},
    series{"both", "skin", "list skin over smallest radius", "skin", finest::largest, false, false},
    series{"both", "viscosity", "γ_t with Eq. 12 (N s/m)", "tangential-viscosity", finest::largest, false, false,
           beyond::reference},
    series{"both", "viscous_time_step", "time step with Eq. 12 (s)", "time-step", finest::smallest, false, false}};

double stress_of(const run& r, const std::string& test) {
  return test == "shear" ? r.number("strength", "residual_shear_stress_Pa") : r.number("strength", "peak_stress_Pa");
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Processor time of the test; a job that was stopped and went on has measured a part of its steps only.
double time_of(const seeds& s) {
  return median(each(s, [](const run& r) {
    const bool shear = r.has_option("shear-speed");
    const double duration =
        shear ? r.numeric_option("displacement") / r.numeric_option("shear-speed") : r.numeric_option("duration");
    return r.number("cost", "processor_s_per_step") * duration / r.numeric_option("time-step");
  }));
}

/// Over the mean of the best; by seed where the packings are the same.
measured change_from(const seeds& best, const seeds& s, const std::string& test, bool own_packings) {
  const auto stress = [&](const run& r) { return stress_of(r, test); };
  const measured whole = mean_of(each(best, stress));
  if (own_packings && &s != &best) {
    const measured part = mean_of(each(s, stress));
    return {part.mean / whole.mean - 1, std::hypot(part.error, whole.error) / whole.mean};
  }
  const measured found = mean_of(by_seed(s, best, [&](const run& r, const run& b) { return stress(r) - stress(b); }));
  return {found.mean / whole.mean, found.error / whole.mean};
}

/// A setting and its runs.
using setting = std::pair<std::string, seeds>;

point point_of(const setting& of, const seeds& best, const series& kind, const std::string& test) {
  const auto& [value, s] = of;
  point p;
  p.value = value;
  p.stress = mean_of(each(s, [&](const run& r) { return stress_of(r, test); }));
  p.change = change_from(best, s, test, kind.own_packings);
  p.time = time_of(s);
  p.seeds = s.size();
  p.worst_book = 0;
  for (const run& r : s) p.worst_book = std::max(p.worst_book, std::abs(r.number("energy", "relative_imbalance")));
  return p;
}

bool finer(const series& kind, const setting& a, const setting& b) {
  const double value_a = std::stod(a.first), value_b = std::stod(b.first);
  return kind.best == finest::smallest ? value_a < value_b : value_a > value_b;
}

/// The runs of the reference, or of anything, on the packings of a series.
seeds with_seeds_of(const seeds& some, const seeds& reference) {
  seeds found;
  for (const run& r : reference) {
    if (std::any_of(some.begin(), some.end(), [&](const run& s) { return s.option("seed") == r.option("seed"); })) {
      found.push_back(r);
    }
  }
  return found;
}

/// The mass as it is at the finest step of another series, as mass and step go together.
std::vector<setting> finest_step(const setting& coarser, const std::filesystem::path& folder) {
  std::vector<setting> steps = cases(folder / "time_step");
  if (steps.empty()) return {};
  const auto smallest = std::min_element(steps.begin(), steps.end(), [](const setting& a, const setting& b) {
    return std::stod(a.first) < std::stod(b.first);
  });
  return {{coarser.first + " at " + smallest->first + " s", smallest->second}};
}

/// None, or one setting: the finest step of all, or the reference, whose friction has no rate.
std::vector<setting> beyond_finest(const series& kind, const setting& best, const std::filesystem::path& folder,
                                   const seeds& reference) {
  if (kind.finer == beyond::finest_step) return finest_step(best, folder);
  if (kind.finer == beyond::reference) return {{"`coulomb_spring`", with_seeds_of(best.second, reference)}};
  return {};
}

study study_of(const series& kind, const std::filesystem::path& folder, const seeds& reference,
               const std::string& test) {
  study found{test, kind.name, kind.title, {}};
  std::vector<setting> settings = cases(folder / kind.name);
  if (settings.empty()) return found;
  if (kind.with_reference) {
    const seeds& others = settings.front().second;
    settings.emplace_back(reference.front().option(kind.option),
                          kind.own_packings ? reference : with_seeds_of(others, reference));
  }
  std::stable_sort(settings.begin(), settings.end(),
                   [&](const setting& a, const setting& b) { return finer(kind, a, b); });
  const std::vector<setting> best = beyond_finest(kind, settings.front(), folder, reference);
  settings.insert(settings.begin(), best.begin(), best.end());
  for (const setting& s : settings) {
    found.points.push_back(point_of(s, settings.front().second, kind, test));
    found.points.back().time /= time_of(reference);
  }
  return found;
}

/// Tidy values for a reader: 4e-06 and 0.0025 as they are meant.
std::string tidy(const std::string& value) {
  try {
    std::size_t used = 0;
    const double x = std::stod(value, &used);
    if (used == value.size()) return number("%g", x);
  } catch (const std::exception&) {  // a name
  }
  return value;
}

}  // namespace

std::vector<study> read(const std::filesystem::path& folder, const std::string& test) {
  std::vector<study> found;
  const seeds reference = runs_of(folder / test / "reference" / "reference");
  for (const series& kind : all_series) {
    if (kind.test == test || kind.test == std::string("both")) {
      found.push_back(study_of(kind, folder / test, reference, test));
    }
  }
  return found;
}

std::string table_of(const std::vector<study>& studies, const std::string& test) {
  examples::markdown::table text({"setting", "value", test == "shear" ? "residual stress (Pa)" : "peak stress (Pa)",
                                  "seeds", "change from the finest (%)", "run time over the reference's",
                                  "energy book"});
  for (const study& s : studies) {
    if (s.test != test) continue;
    if (s.points.empty()) text.add({s.title, "not run yet", "", "", "", "", ""});
    for (const point& p : s.points) {
      const bool best = &p == &s.points.front();
      text.add({best ? s.title : "", tidy(p.value), number("%.1f", p.stress.mean, p.stress.error),
                std::to_string(p.seeds),
                best ? "finest" : number("%+.1f", 100 * p.change.mean) + " ± " + number("%.1f", 100 * p.change.error),
                number("%.2f", p.time), number("%.0e", p.worst_book)});
    }
  }
  return text.text();
}

void draw(const std::vector<study>& studies, const std::string& test, const std::filesystem::path& file) {
  pendular::io::plot p;
  p.title = test == "shear" ? "Direct shear: error of the residual stress against run time"
                            : "Simple compression: error of the peak stress against run time";
  p.x_label = "run time over that of the reference";
  p.y_label = "change from the finest setting (%)";
  p.logarithmic_x = true;
  for (const study& s : studies) {
    if (s.test != test || s.points.size() < 2) continue;
    pendular::io::curve c{s.title, {}, {}, pendular::io::curve_style::linespoints, {}, {}};
    for (const point& q : s.points) {
      c.x.push_back(q.time), c.y.push_back(100 * q.change.mean), c.error.push_back(100 * q.change.error);
    }
    p.curves.push_back(c);
  }
  pendular::io::draw(p, file);
}

std::string table_of_laws(const std::filesystem::path& folder) {
  const auto runs = [&](const std::string& test, const std::string& law) {
    return runs_of(folder / test / (law == "richefeu" ? "reference/reference" : "law/" + law));
  };
  const seeds dry = runs_of(folder / "shear" / "dry" / "dry");
  examples::markdown::table text({"capillary law", "seeds", "peak stress in compression (Pa)", "over Laplace-Young (%)",
                                  "seeds", "residual shear stress less dry (Pa)", "processor time over richefeu's"});
  for (const char* law : {"richefeu", "richefeu-harmonic", "willett", "laplace-young"}) {
    const seeds compressed = runs("compression", law), sheared = with_seeds_of(dry, runs("shear", law));
    const measured peak = mean_of(each(compressed, [](const run& r) { return stress_of(r, "compression"); }));
    const measured change = change_from(runs("compression", "laplace-young"), compressed, "compression", false);
    const measured added = mean_of(by_seed(sheared, dry, [](const run& wet, const run& without) {
      return stress_of(wet, "shear") - stress_of(without, "shear");
    }));
    text.add({std::string("`") + law + "`", std::to_string(compressed.size()), number("%.0f", peak.mean, peak.error),
              number("%+.1f", 100 * change.mean) + " ± " + number("%.1f", 100 * change.error),
              std::to_string(sheared.size()), number("%.0f", added.mean, added.error),
              number("%.2f", time_of(compressed) / time_of(runs("compression", "richefeu")))});
  }
  return text.text();
}

/// Stress at 1.3 to 1.6 mean diameters of shortening over that at 0.2 to 0.5.
double left_of(const run& r) {
  const xy c = stress_curve(r);
  return mean_between(c, 1.3, 1.6) / mean_between(c, 0.2, 0.5);
}

std::vector<rate_point> read_rates(const std::filesystem::path& folder) {
  std::vector<rate_point> found;
  for (const auto& [name, s] : cases(folder / "compression" / "viscosity_and_speed")) {
    found.push_back({s.front().numeric_option("tangential-viscosity"), s.front().numeric_option("wall-speed"),
                     mean_of(each(s, [](const run& r) { return stress_of(r, "compression"); })),
                     mean_of(each(s, left_of)), s.size()});
  }
  if (found.empty()) throw std::runtime_error("no job of viscosity_and_speed has ended in " + folder.string());
  std::sort(found.begin(), found.end(), [](const rate_point& a, const rate_point& b) {
    return std::pair(a.viscosity, a.speed) < std::pair(b.viscosity, b.speed);
  });
  return found;
}

std::string table_of(const std::vector<rate_point>& rates) {
  examples::markdown::table text({"γ_t (N s/m)", "speed (mm/s)", "γ_t times speed (mN)", "seeds", "largest stress (Pa)",
                                  "at 1.3 to 1.6 diameters over that at 0.2 to 0.5 (%)"});
  for (const rate_point& r : rates) {
    text.add({number("%g", r.viscosity), number("%g", 1e3 * r.speed), number("%.3g", 1e3 * r.viscosity * r.speed),
              std::to_string(r.seeds), number("%.0f", r.stress.mean, r.stress.error),
              number("%.0f", 100 * r.left.mean, 100 * r.left.error)});
  }
  return text.text();
}

void draw(const std::vector<rate_point>& rates, const std::filesystem::path& file) {
  pendular::io::plot p;
  p.title = "Simple compression with the friction of Eq. 12";
  p.x_label = "γ_t times wall speed (mN)";
  p.y_label = "largest axial stress (Pa)";
  p.logarithmic_x = true;
  for (const rate_point& r : rates) {
    const std::string label = "γ_t = " + number("%g", r.viscosity) + " N s/m";
    if (p.curves.empty() || p.curves.back().label != label) {
      p.curves.push_back({label, {}, {}, pendular::io::curve_style::linespoints, {}, {}});
    }
    auto& c = p.curves.back();
    c.x.push_back(1e3 * r.viscosity * r.speed), c.y.push_back(r.stress.mean), c.error.push_back(r.stress.error);
  }
  pendular::io::draw(p, file);
}

}  // namespace paper::convergence
