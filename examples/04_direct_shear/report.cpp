// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include "../common/curve.hpp"

#include <pendular/io/plot.hpp>
#include <pendular/io/table.hpp>
#include <pendular/observe/circle_overlap.hpp>
#include <pendular/scene/packing.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace {

using json = nlohmann::ordered_json;
using line = pendular::scene::shear_record;

/// The curve, column by column.
class curve {
 public:
  curve(const std::vector<line>& lines, double mean_diameter) : lines_(lines), mean_diameter_(mean_diameter) {}

  template <class Value>
  std::vector<double> column(const Value& value) const {
    std::vector<double> values;
    for (const line& l : lines_) values.push_back(value(l));
    return values;
  }
  /// Over the mean diameter.
  std::vector<double> displacement() const {
    return column([&](const line& l) { return l.displacement / mean_diameter_; });
  }
  std::vector<double> shear_stress() const {
    return column([](const line& l) { return l.stress.shear; });
  }
  std::vector<double> plane_stress() const {
    return column([](const line& l) { return l.stress.plane; });
  }
  std::vector<double> smooth() const {
    constexpr double window = 0.05;  // mean diameters
    return examples::smoothed(displacement(), shear_stress(), window);
  }

 private:
  const std::vector<line>& lines_;
  double mean_diameter_;
};

/// Of the halves of the cell, over its area.
std::vector<double> shared_area(const options& o, const curve& c) {
  const double radius = o.cell_radius(), whole = std::numbers::pi * radius * radius;
  return c.column(
      [&](const line& l) { return pendular::observe::circle_overlap(radius, radius, l.displacement) / whole; });
}

void write_curve(const options& o, const curve& c) {
  const auto add = [&](const char* name, auto value) { return pendular::io::column{name, c.column(value)}; };
  pendular::io::write_table(o.output / "shear_curve.csv",
                            pendular::io::table(std::vector<pendular::io::column>{
                                add("time_s", [](const line& l) { return l.time; }),
                                add("displacement_m", [](const line& l) { return l.displacement; }),
                                {"displacement_over_mean_diameter", c.displacement()},
                                {"shear_stress_Pa", c.shear_stress()},
                                {"shear_stress_smoothed_Pa", c.smooth()},
                                add("lid_stress_Pa", [](const line& l) { return l.stress.lid; }),
                                {"plane_stress_Pa", c.plane_stress()},
                                {"shared_area_over_cell", shared_area(o, c)},
                                add("height_m", [](const line& l) { return l.height; }),
                                add("contacts_per_grain", [](const line& l) { return l.contacts; }),
                                add("bridges_per_grain", [](const line& l) { return l.bridges; }),
                                add("liquid_over_introduced", [](const line& l) { return l.liquid; }),
                                add("energy_imbalance_J", [](const line& l) { return l.energy.imbalance; }),
                                add("energy_turnover_J", [](const line& l) { return l.energy.turnover; })}));
}

void draw_curve(const options& o, const curve& c) {
  pendular::io::plot p;
  char title[160];
  std::snprintf(title, sizeof title, "Direct shear, w = %g %%, lid %g Pa, %lld grains, %s, %g mm/s",
                100 * o.water_content, o.normal_stress, static_cast<long long>(o.grains), o.friction.c_str(),
                1e3 * o.shear_speed);
  p.title = title;
  p.x_label = "displacement over mean diameter";
  p.y_label = "shear stress (Pa)";
  p.curves.push_back({"every sample", c.displacement(), c.shear_stress(), pendular::io::curve_style::points, 4});
  p.curves.push_back({"mean over 0.05 diameters", c.displacement(), c.smooth(), pendular::io::curve_style::lines, 0});
  pendular::io::draw(p, o.output / "shear_curve.png");
}

/// Shear rate across five mean diameters times the time in which the load moves a grain by its size.
double inertial_number(const options& o) {
  return o.shear_speed / 5 *
         std::sqrt(pendular::scene::packing_parameters{}.density * o.mass_scaling / o.normal_stress);
}

json strength(const options& o, const curve& c) {
  const auto way = c.displacement(), smooth = c.smooth();
  const auto shear = examples::mean_beyond(way, c.shear_stress(), o.residual_from);
  const auto plane = examples::mean_beyond(way, c.plane_stress(), o.residual_from);
  const auto top = std::max_element(smooth.begin(), smooth.end());
  return {{"normal_stress_Pa", o.normal_stress},
          {"residual_from_mean_diameters", o.residual_from},
          {"residual_shear_stress_Pa", shear.mean},
          {"residual_shear_stress_error_Pa", shear.error},
          {"plane_stress_Pa", plane.mean},
          {"plane_stress_error_Pa", plane.error},
          {"peak_shear_stress_Pa", *top},
          {"displacement_at_peak_mean_diameters", way[static_cast<std::size_t>(top - smooth.begin())]},
          {"inertial_number", inertial_number(o)}};
}

json summary(const options& o, const pendular::scene::shear_result& r, const curve& c, const examples::run_facts& f) {
  const auto& last = r.records.back();
  json s{{"options", o.physics()},
         {"sample",
          {{"deposited_height_m", r.sample.deposited_height},
           {"consolidation_time_s", r.sample.consolidation_time},
           {"solid_fraction", r.sample.solid_fraction},
           {"split_height_m", r.sample.split_height},
           {"start_height_m", r.sample.start.height},
           {"bridges_per_grain_initial", r.sample.initial_bridges},
           {"bridges_per_grain_start", r.sample.start.bridges},
           {"unbalanced_force_ratio", r.sample.start.unbalanced_force},
           {"shear_stress_start_Pa", r.sample.start.shear_stress},
           {"solid_fraction_start", r.sample.start.density.cell},
           {"solid_fraction_bulk", r.sample.start.density.bulk},
           {"solid_fraction_near_walls", r.sample.start.density.near_walls},
           {"mean_diameter_m", f.mean_diameter}}},
         {"strength", strength(o, c)},
         {"end",
          {{"displacement_m", last.displacement},
           {"height_m", last.height},
           {"contacts_per_grain", last.contacts},
           {"bridges_per_grain", last.bridges}}}};
  put_facts(s, f);
  return s;
}

void print(const json& s) {
  const auto number = [&](const char* part, const char* name) {
    return s[part][name].is_number() ? s[part][name].get<double>() : std::nan("");
  };
  std::printf("\nSample       solid fraction %.4f after %.3f s, height %.3f mm, split at %.3f mm\n",
              number("sample", "solid_fraction"), number("sample", "consolidation_time_s"),
              1e3 * number("sample", "start_height_m"), 1e3 * number("sample", "split_height_m"));
  std::printf("Density      at the start %.4f over the cell, %.4f in the bulk, %.4f near the walls\n",
              number("sample", "solid_fraction_start"), number("sample", "solid_fraction_bulk"),
              number("sample", "solid_fraction_near_walls"));
  std::printf("Shear        residual %.1f +- %.1f Pa from %g mean diameters on, peak %.1f Pa at %.2f\n",
              number("strength", "residual_shear_stress_Pa"), number("strength", "residual_shear_stress_error_Pa"),
              number("strength", "residual_from_mean_diameters"), number("strength", "peak_shear_stress_Pa"),
              number("strength", "displacement_at_peak_mean_diameters"));
  std::printf("Normal       lid %.1f Pa; on the plane between the halves %.1f +- %.1f Pa\n",
              number("strength", "normal_stress_Pa"), number("strength", "plane_stress_Pa"),
              number("strength", "plane_stress_error_Pa"));
  std::printf("Rate         inertial number %.1e in a band of five diameters\n", number("strength", "inertial_number"));
  std::printf("Coordination contacts %.3f, bridges %.3f per grain (%.3f as distributed)\n",
              number("end", "contacts_per_grain"), number("end", "bridges_per_grain"),
              number("sample", "bridges_per_grain_initial"));
}

}  // namespace

void report(const options& o, const pendular::scene::shear_result& result, const examples::run_facts& facts) {
  const curve c(result.records, facts.mean_diameter);
  write_curve(o, c);
  if (o.pictures) draw_curve(o, c);
  const json s = summary(o, result, c, facts);
  write_summary(o, s);
  print(s);
  print_facts(facts);
  std::printf("Results in   %s\n", o.output.string().c_str());
}
