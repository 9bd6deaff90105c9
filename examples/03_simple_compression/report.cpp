// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <pendular/io/collection.hpp>
#include <pendular/io/picture.hpp>
#include <pendular/io/plot.hpp>
#include <pendular/io/table.hpp>
#include <pendular/io/vtk.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace {

using json = nlohmann::ordered_json;
using records = std::vector<pendular::scene::compression_record>;

std::vector<double> column(const records& lines, double pendular::scene::compression_record::*member, double factor) {
  std::vector<double> values;
  for (const auto& line : lines) values.push_back(factor * line.*member);
  return values;
}

/// Mean over the window of shortening around every line.
std::vector<double> smoothed(const records& lines, double window) {
  std::vector<double> values(lines.size());
  std::size_t from = 0, to = 0;
  double sum = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    while (to < lines.size() && lines[to].shortening <= lines[k].shortening + 0.5 * window) sum += lines[to++].stress;
    while (lines[from].shortening < lines[k].shortening - 0.5 * window) sum -= lines[from++].stress;
    values[k] = sum / static_cast<double>(to - from);
  }
  return values;
}

constexpr double smoothing_window = 20e-6;  // m

void write_curve(const options& o, const records& lines) {
  using r = pendular::scene::compression_record;
  pendular::io::write_table(
      o.output / "stress_strain.csv",
      pendular::io::table(std::vector<pendular::io::column>{{"time_s", column(lines, &r::time, 1)},
                                                            {"shortening_m", column(lines, &r::shortening, 1)},
                                                            {"axial_stress_Pa", column(lines, &r::stress, 1)},
                                                            {"contacts_per_grain", column(lines, &r::contacts, 1)},
                                                            {"bridges_per_grain", column(lines, &r::bridges, 1)},
                                                            {"liquid_over_introduced", column(lines, &r::liquid, 1)},
                                                            {"energy_imbalance_J", column(lines, &r::imbalance, 1)},
                                                            {"energy_turnover_J", column(lines, &r::turnover, 1)}}));
}

void draw_curve(const options& o, const records& lines, double mean_diameter) {
  using r = pendular::scene::compression_record;
  const auto strain = column(lines, &r::shortening, 1 / mean_diameter);
  pendular::io::plot p;
  char title[160];
  std::snprintf(title, sizeof title, "Simple compression, w = %g %%, %lld grains, %s, wall at %g mm/s",
                100 * o.water_content, static_cast<long long>(o.grains), o.friction.c_str(), 1e3 * o.wall_speed);
  p.title = title;
  p.x_label = "shortening over mean diameter";
  p.y_label = "axial stress (Pa)";
  p.curves.push_back({"every sample", strain, column(lines, &r::stress, 1), pendular::io::curve_style::points, 4});
  p.curves.push_back(
      {"mean over 0.02 mm", strain, smoothed(lines, smoothing_window), pendular::io::curve_style::lines, 0});
  pendular::io::draw(p, o.output / "stress_strain.png");
}

json energy_entries(const pendular::observe::energies& e) {
  return {{"kinetic_J", e.kinetic},
          {"gravity_J", e.gravity},
          {"elastic_J", e.elastic},
          {"capillary_J", e.capillary},
          {"damping_J", e.damping},
          {"friction_J", e.friction},
          {"friction_springs_J", e.friction_springs},
          {"liquid_J", e.liquid},
          {"walls_J", e.walls}};
}

json summary(const options& o, const pendular::scene::compression_result& r, const run_facts& f) {
  const auto& last = r.records.back();
  const peak top = find_peak(r.records);
  const double per_step = f.compression_steps > 0 ? f.compression_time / static_cast<double>(f.compression_steps) : 0;
  double worst_liquid = 0;
  for (const auto& line : r.records) worst_liquid = std::max(worst_liquid, std::abs(line.liquid - 1));
  return {{"options", o.physics()},
          {"departures_from_the_paper", departures(o)},
          {"limits", f.limits},
          {"sample",
           {{"sealed_height_m", r.sealed_height},
            {"solid_fraction", r.solid_fraction},
            {"bridges_per_grain_initial", r.initial_bridges},
            {"bridges_per_grain_relaxed", r.relaxed_bridges},
            {"surface_settlement_m", r.surface_settlement},
            {"centre_settlement_m", r.centre_settlement},
            {"unbalanced_force_ratio", r.unbalanced_force},
            {"start_height_m", r.start_height},
            {"mean_diameter_m", f.mean_diameter}}},
          {"strength",
           {{"peak_stress_Pa", top.stress},
            {"shortening_at_peak_m", top.shortening},
            {"last_stress_Pa", top.last},
            {"last_shortening_m", last.shortening}}},
          {"coordination",
           {{"contacts_per_grain", last.contacts},
            {"bridges_per_grain", last.bridges},
            {"ruptures", f.ruptures},
            {"formations", f.formations}}},
          {"liquid",
           {{"introduced_m3", f.liquid_volume},
            {"worst_relative_loss", worst_liquid},
            {"largest_bridge_over_R3", f.largest_bridge},
            {"bridges_made_outside_of_capillary_law", f.outside_capillary_law},
            {"bridges_made_outside_of_rupture_law", f.outside_rupture_law}}},
          {"energy",
           {{"at_start", energy_entries(r.energy_at_start)},
            {"at_end", energy_entries(f.energy_at_end)},
            {"imbalance_J", last.imbalance},
            {"turnover_J", last.turnover},
            {"relative_imbalance", last.turnover > 0 ? last.imbalance / last.turnover : 0}}},
          {"cost",
           {{"threads", f.threads},
            {"wall_time_s", f.wall_time},
            {"compression_time_s", f.compression_time},
            {"compression_steps", f.compression_steps},
            {"ns_per_grain_and_step", 1e9 * per_step / static_cast<double>(o.grains)}}}};
}

void print(const options& o, const json& s) {
  const auto& sample = s["sample"];
  const auto number = [](const json& v) { return v.get<double>(); };
  std::printf("\nSample       sealed at %.3f mm, solid fraction %.4f; settled by %.4f mm (surface), %.4f mm (centre)\n",
              1e3 * number(sample["sealed_height_m"]), number(sample["solid_fraction"]),
              1e3 * number(sample["surface_settlement_m"]), 1e3 * number(sample["centre_settlement_m"]));
  std::printf("Strength     peak %.1f Pa at %.3f mm shortening; %.1f Pa at the end, %.3f mm\n",
              number(s["strength"]["peak_stress_Pa"]), 1e3 * number(s["strength"]["shortening_at_peak_m"]),
              number(s["strength"]["last_stress_Pa"]), 1e3 * number(s["strength"]["last_shortening_m"]));
  std::printf(
      "Coordination contacts %.3f, bridges %.3f per grain (%.3f as distributed); %lld ruptures, %lld formations\n",
      number(s["coordination"]["contacts_per_grain"]), number(s["coordination"]["bridges_per_grain"]),
      number(sample["bridges_per_grain_initial"]), s["coordination"]["ruptures"].get<long long>(),
      s["coordination"]["formations"].get<long long>());
  std::printf("Liquid       %.4e m3, worst relative change of the total %.1e\n", number(s["liquid"]["introduced_m3"]),
              number(s["liquid"]["worst_relative_loss"]));
  std::printf("Validity     bridges made beyond the range of the law: %lld capillary, %lld rupture\n",
              s["liquid"]["bridges_made_outside_of_capillary_law"].get<long long>(),
              s["liquid"]["bridges_made_outside_of_rupture_law"].get<long long>());
  std::printf("Energy       imbalance %.2e J of %.2e J turned over (%.1e)\n", number(s["energy"]["imbalance_J"]),
              number(s["energy"]["turnover_J"]), number(s["energy"]["relative_imbalance"]));
  std::printf("Cost         %.1f s in all on %d threads, %.1f ns per grain and step in the compression\n",
              number(s["cost"]["wall_time_s"]), s["cost"]["threads"].get<int>(),
              number(s["cost"]["ns_per_grain_and_step"]));
  for (const auto& line : s["limits"]) std::printf("Limit        %s\n", line.get<std::string>().c_str());
  for (const auto& line : s["departures_from_the_paper"])
    std::printf("Departure    %s\n", line.get<std::string>().c_str());
  std::printf("Results in   %s\n", o.output.string().c_str());
}

std::string numbered(const char* stem, int number) {
  char name[64];
  std::snprintf(name, sizeof name, "%s_%04d.vtp", stem, number);
  return name;
}

}  // namespace

peak find_peak(const records& lines) {
  if (lines.empty()) return {};
  const auto stress = smoothed(lines, smoothing_window);
  const auto top = std::max_element(stress.begin(), stress.end());
  return {*top, lines[static_cast<std::size_t>(top - stress.begin())].shortening, stress.back()};
}

std::vector<std::string> departures(const options& o) {
  std::vector<std::string> list;
  const options usual;
  const auto add = [&](bool differs, const auto&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    if (differs) list.push_back(text.str());
  };
  add(o.friction == "coulomb-spring",
      "friction: tangential spring of 800 N/m with Coulomb limit; the paper has Eq. 12");
  add(o.friction == "viscous-coulomb", "friction: Eq. 12 in this library's form that is stable at any step");
  add(o.time_step != 1e-6, "time step: ", o.time_step, " s; the companion paper has 1e-6 s");
  add(o.mass_scaling != 1, "mass: inertia times ", o.mass_scaling,
      " in the test, weight as it is; the paper gives no factor");
  add(o.grains != usual.grains, "grains: ", o.grains, " in a smaller cylinder; the paper has 8000 in 25 mm");
  add(o.wall_speed != usual.wall_speed, "wall speed: ", o.wall_speed, " m/s; the paper has 1 mm/s");
  add(o.duration != usual.duration, "duration: ", o.duration, " s; the paper has 2 s");
  add(o.law != usual.law, "capillary law: ", o.law, "; the paper has Eqs. 4-11");
  add(o.thinning != 1, "bonds: one in ", o.thinning, " kept");
  add(o.preparation_friction != 0, "preparation: friction ", o.preparation_friction,
      " between grains; the paper does not say");
  add(o.surface_tension_force != usual.surface_tension_force, "kappa: ", o.surface_tension_force,
      " N/m; the companion paper has 0.4");
  add(true, "damping: two-sided in contact, sign of Eq. 3 corrected (companion paper)");
  add(true, "time step rule: 10 % of pi sqrt(m/k) for the paper's \"10 % below\"");
  return list;
}

void report(const options& o, const pendular::scene::compression_result& result, const run_facts& facts) {
  write_curve(o, result.records);
  if (o.pictures) draw_curve(o, result.records, facts.mean_diameter);
  const json s = summary(o, result, facts);
  std::ofstream file(o.output / "summary.json");
  file << s.dump(2) << '\n';
  if (!file.flush()) throw std::runtime_error("summary.json cannot be written in " + o.output.string());
  print(o, s);
}

void write_snapshot(const options& o, const snapshot& s, int number) {
  using pendular::io::field;
  const auto displacement =
      pendular::io::vector_field("displacement", s.displacement_x, s.displacement_y, s.displacement_z);
  pendular::io::write_points(o.output / numbered("grains", number), s.x, s.y, s.z,
                             {field("radius", 1, s.radius), displacement, field("liquid", 1, s.liquid)});
  pendular::io::write_lines(
      o.output / numbered("bonds", number), s.x, s.y, s.z, s.bonds, {},
      {field("force", 1, s.bond_force), field("volume", 1, s.bond_volume), field("gap", 1, s.bond_gap)});
  for (const char* stem : {"grains", "bonds"}) {
    std::vector<pendular::io::collection::entry> before;
    for (int k = 0; k < number; ++k) {
      const double interval = s.time / std::max(number, 1);
      before.push_back({interval * k, o.output / numbered(stem, k)});
    }
    pendular::io::collection series(o.output / (std::string(stem) + ".pvd"), before);
    series.add(s.time, o.output / numbered(stem, number));
  }
}

void draw_sample(const options& o, const snapshot& s, double lid_height) {
  if (!o.pictures) return;
  std::vector<double> millimetres(s.displacement.size());
  std::transform(s.displacement.begin(), s.displacement.end(), millimetres.begin(), [](double d) { return 1e3 * d; });
  pendular::io::picture p{s.x, s.y, s.z, s.radius};
  p.value = millimetres;
  p.value_label = "displacement (mm)";
  p.plates = {0.0, lid_height};
  p.axis = {0.0, 0.0};
  pendular::io::render(p, o.output / "sample.png");
  p.section = true;
  pendular::io::render(p, o.output / "section.png");
}
