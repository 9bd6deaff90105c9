// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include "figures.hpp"

#include <pendular/io/table.hpp>
#include <pendular/scene/box_walls.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

using json = nlohmann::ordered_json;
namespace observe = pendular::observe;

/// Of the quantity 1: rho(k+, k-).
Eigen::MatrixXd joint(const std::vector<observe::pair_signs>& signs) {
  return observe::class_shares(signs, std::vector<double>(signs.size(), 1.0));
}

void write_relaxation(const options& o, const pendular::scene::cohesive_result& r) {
  pendular::io::table table{
      "time_s",         "solid_fraction",         "contacts_per_grain", "bridges_per_grain", "unbalanced_force_ratio",
      "wall_stress_Pa", "liquid_over_introduced", "energy_imbalance_J", "energy_turnover_J"};
  for (const auto& l : r.records) {
    table.add_row({l.time, l.solid_fraction, l.contacts, l.bridges, l.unbalanced_force, l.wall_stress, l.liquid,
                   l.energy.imbalance, l.energy.turnover});
  }
  pendular::io::write_table(o.output / "relaxation.csv", table);
}

/// rho(k+, k-) and the partial pressures, a line for each class.
void write_classes(const options& o, const microstructure& m) {
  const Eigen::MatrixXd share = joint(m.signs), pressure = observe::class_shares(m.signs, m.pressures);
  pendular::io::table table{"compressive", "tensile", "share_of_grains", "partial_pressure_over_p0"};
  for (Eigen::Index a = 0; a < share.rows(); ++a) {
    for (Eigen::Index b = 0; b < share.cols(); ++b) {
      if (share(a, b) == 0) continue;
      table.add_row(
          {static_cast<double>(a), static_cast<double>(b), share(a, b), pressure(a, b) / o.reference_pressure()});
    }
  }
  pendular::io::write_table(o.output / "classes.csv", table);
}

json of_decay(const observe::exponential_decay& d, observe::decay_window w) {
  return {{"alpha", d.rate}, {"error", d.error}, {"forces", d.count}, {"from_f0", w.low}, {"to_f0", w.high}};
}

json of_grains(const std::vector<observe::pair_signs>& signs) {
  const mean_neighbours z = mean_of(signs);
  const Eigen::MatrixXd rho = joint(signs);
  if (rho.size() == 0) return {{"grains", 0}};
  const auto peak = peak_of(rho), pressed = peak_of(rho.rowwise().sum()), pulled = peak_of(rho.colwise().sum());
  return {{"grains", signs.size()},
          {"all_per_grain", z.all()},
          {"compressive_per_grain", z.compressive},
          {"tensile_per_grain", z.tensile},
          {"rho_compressive_0", rho.row(0).sum()},
          {"rho_tensile_0", rho.col(0).sum()},
          {"peak_of_rho_compressive", pressed[0]},
          {"peak_of_rho_tensile", pulled[1]},
          {"peak_of_rho", peak},
          {"share_with_as_many_of_both", rho.trace()}};
}

/// Mean neighbours of the grains below -p0, near 0 and above p0.
json of_pressure_classes(const options& o, const microstructure& m) {
  constexpr double all = std::numeric_limits<double>::max(), near = 0.25;
  const double p0 = o.reference_pressure();
  const auto bins =
      observe::signs_by_class(m.signs, m.pressures, std::vector<double>{-all, -p0, -near * p0, near * p0, p0, all});
  const auto entry = [](const observe::mean_signs& b) {
    return json{{"grains", b.grains}, {"compressive_per_grain", b.compressive}, {"tensile_per_grain", b.tensile}};
  };
  return {{"below_minus_p0", entry(bins[0])}, {"within_a_quarter_of_p0", entry(bins[2])}, {"above_p0", entry(bins[4])}};
}

json of_pressures(const options& o, const microstructure& m) {
  const double p0 = o.reference_pressure();
  const Eigen::MatrixXd partial = observe::class_shares(m.signs, m.pressures) / p0;
  std::vector<double> pressed, pulled;
  for (const double p : m.pressures) (p > 0 ? pressed : pulled).push_back(std::abs(p));
  const observe::decay_window window{0.25, 2};
  json s{
      {"p0_Pa", p0},
      {"solid_fraction", m.solid_fraction},
      {"mean_over_p0", partial.sum()},
      {"share_of_grains_in_compression", static_cast<double>(pressed.size()) / static_cast<double>(m.pressures.size())},
      {"compressive_decay", observe::exponential_decay_of(pressed, p0, window).rate},
      {"tensile_decay", observe::exponential_decay_of(pulled, p0, window).rate},
      {"largest_partial_at", peak_of(partial)},
      {"least_partial_at", peak_of(-partial)}};
  s["classes"] = of_pressure_classes(o, m);
  return s;
}

json of_state(const pendular::scene::cohesive_state& state) {
  const pendular::vector size = pendular::scene::size_of(state.room);
  return {{"box_m", {size.x, size.y, size.z}},          {"solid_fraction", state.solid_fraction},
          {"solid_fraction_bulk", state.bulk_fraction}, {"contacts_per_grain", state.contacts},
          {"bridges_per_grain", state.bridges},         {"bridges_across_gaps_per_grain", state.open_bridges}};
}

json summary(const options& o, const pendular::scene::cohesive_result& r, const microstructure& m,
             const examples::run_facts& f) {
  const auto& last = r.records.back();
  json s{{"options", o.physics()}, {"start", of_state(r.start)}, {"end", of_state(r.end)}};
  s["rest"] = {{"time_s", last.time},
               {"unbalanced_force_ratio", last.unbalanced_force},
               {"wall_stress_Pa", last.wall_stress},
               {"packing_unbalanced_force_ratio", r.packing_unbalanced_force}};
  s["forces"] = {{"f0_N", o.largest_pull()},
                 {"largest_over_f0", m.largest_over_f0},
                 {"compressive", of_decay(m.compressive, microstructure::compressive_window)},
                 {"tensile", of_decay(m.tensile, microstructure::tensile_window)}};
  s["neighbours"] = of_grains(m.signs);
  s["neighbours_in_the_bulk"] = of_grains(m.bulk);
  s["pressures"] = of_pressures(o, m);
  put_facts(s, f);
  return s;
}

}  // namespace

void report(const options& o, const pendular::scene::cohesive_result& result, const microstructure& m,
            const examples::run_facts& facts) {
  write_relaxation(o, result);
  write_classes(o, m);
  write_densities(o, m);
  if (o.pictures) draw_densities(o, m);
  const json s = summary(o, result, m, facts);
  write_summary(o, s);
  print_beside_the_paper(s);
  print_facts(facts);
  std::printf("Results in   %s\n", o.output.string().c_str());
}
