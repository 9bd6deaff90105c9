// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include "../common/curve.hpp"

#include <pendular/io/plot.hpp>
#include <pendular/io/table.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using json = nlohmann::ordered_json;
using records = std::vector<pendular::scene::compression_record>;

std::vector<double> column(const records& lines, double pendular::scene::compression_record::*member, double factor) {
  std::vector<double> values;
  for (const auto& line : lines) values.push_back(factor * line.*member);
  return values;
}

std::vector<double> smoothed_stress(const records& lines) {
  using r = pendular::scene::compression_record;
  constexpr double window = 20e-6;  // m
  return examples::smoothed(column(lines, &r::shortening, 1), column(lines, &r::stress, 1), window);
}

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

void write_relaxation(const options& o, const std::vector<pendular::scene::relaxation_record>& lines) {
  const auto column = [&](const char* name, auto member) {
    std::vector<double> values;
    for (const auto& line : lines) values.push_back(line.*member);
    return pendular::io::column{name, values};
  };
  using r = pendular::scene::relaxation_record;
  pendular::io::write_table(
      o.output / "relaxation.csv",
      pendular::io::table(std::vector<pendular::io::column>{
          column("time_s", &r::time), column("surface_settlement_m", &r::surface_settlement),
          column("centre_settlement_m", &r::centre_settlement), column("bridges_per_grain", &r::bridges)}));
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
  p.curves.push_back({"mean over 0.02 mm", strain, smoothed_stress(lines), pendular::io::curve_style::lines, 0});
  pendular::io::draw(p, o.output / "stress_strain.png");
}

json summary(const options& o, const pendular::scene::compression_result& r, const examples::run_facts& f,
             const still_grains& still) {
  const auto& last = r.records.back();
  const auto stress = smoothed_stress(r.records);
  const auto top = std::max_element(stress.begin(), stress.end());
  json s{{"options", o.physics()},
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
          {{"peak_stress_Pa", *top},
           {"shortening_at_peak_m", r.records[static_cast<std::size_t>(top - stress.begin())].shortening},
           {"last_stress_Pa", stress.back()},
           {"last_shortening_m", last.shortening}}},
         {"still_grains",
          {{"share", still.share}, {"share_by_fifth_of_height", still.by_slice}, {"radius_by_fifth_m", still.radius}}},
         {"coordination", {{"contacts_per_grain", last.contacts}, {"bridges_per_grain", last.bridges}}}};
  put_facts(s, f);
  return s;
}

void print(const json& s) {
  const auto number = [&](const char* part, const char* name) { return s[part][name].get<double>(); };
  std::printf("\nSample       sealed at %.3f mm, solid fraction %.4f; settled by %.4f mm (surface), %.4f mm (centre)\n",
              1e3 * number("sample", "sealed_height_m"), number("sample", "solid_fraction"),
              1e3 * number("sample", "surface_settlement_m"), 1e3 * number("sample", "centre_settlement_m"));
  std::printf("Strength     peak %.1f Pa at %.3f mm shortening; %.1f Pa at the end, %.3f mm\n",
              number("strength", "peak_stress_Pa"), 1e3 * number("strength", "shortening_at_peak_m"),
              number("strength", "last_stress_Pa"), 1e3 * number("strength", "last_shortening_m"));
  std::printf("Coordination contacts %.3f, bridges %.3f per grain (%.3f as distributed)\n",
              number("coordination", "contacts_per_grain"), number("coordination", "bridges_per_grain"),
              number("sample", "bridges_per_grain_initial"));
}

}  // namespace

void report(const options& o, const pendular::scene::compression_result& result, const examples::run_facts& facts,
            const still_grains& still) {
  write_curve(o, result.records);
  if (!result.relaxation.empty()) write_relaxation(o, result.relaxation);
  if (o.pictures) draw_curve(o, result.records, facts.mean_diameter);
  const json s = summary(o, result, facts, still);
  write_summary(o, s);
  print(s);
  print_facts(facts);
  std::printf("Results in   %s\n", o.output.string().c_str());
}
