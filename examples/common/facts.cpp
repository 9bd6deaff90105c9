// SPDX-License-Identifier: BSD-3-Clause
#include "facts.hpp"

#include <pendular/core/simd_register.hpp>
#include <pendular/io/atomic_file.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace examples {

using json = nlohmann::ordered_json;

namespace {

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

double relative_imbalance(const run_facts& f) { return f.turnover > 0 ? f.imbalance / f.turnover : 0; }

double ns_per_grain_and_step(const run_facts& f) {
  return f.test_steps > 0 ? 1e9 * f.test_time / static_cast<double>(f.test_steps) / f.grains : 0;
}

double processor_seconds_per_step(const run_facts& f) {
  return f.test_steps > 0 ? f.test_processor_time / static_cast<double>(f.test_steps) : 0;
}

}  // namespace

void put_facts(json& s, const run_facts& f) {
  s["liquid"] = {{"introduced_m3", f.liquid_volume},
                 {"worst_relative_loss", f.worst_liquid},
                 {"largest_bridge_over_R3", f.largest_bridge},
                 {"ruptures", f.ruptures},
                 {"formations", f.formations},
                 {"bridges_made_outside_of_capillary_law", f.outside_capillary_law},
                 {"bridges_made_outside_of_rupture_law", f.outside_rupture_law}};
  s["network_at_end"] = {{"contacts_per_grain", f.network.neighbours.contacts},
                         {"bridges_per_grain", f.network.neighbours.bridges},
                         {"bridges_across_gaps_per_grain", f.network.neighbours.open_bridges},
                         {"tensile_per_grain", f.network.tensile},
                         {"fabric_xx_yy_zz", f.network.fabric},
                         {"mean_compressive_force_N", f.network.mean_compressive},
                         {"mean_tensile_force_N", f.network.mean_tensile}};
  s["energy"] = {{"at_start", energy_entries(f.energy_at_start)},
                 {"at_end", energy_entries(f.energy_at_end)},
                 {"imbalance_J", f.imbalance},
                 {"turnover_J", f.turnover},
                 {"relative_imbalance", relative_imbalance(f)}};
  s["cost"] = {{"threads", f.threads},
               {"instruction_set", pendular::simd::instruction_set},
               {"wall_time_s", f.wall_time},
               {"test_time_s", f.test_time},
               {"test_steps", f.test_steps},
               {"processor_s_per_step", processor_seconds_per_step(f)},
               {"ns_per_grain_and_step", ns_per_grain_and_step(f)}};
  s["limits"] = f.limits;
  s["departures_from_the_paper"] = f.departures;
}

void print_facts(const run_facts& f) {
  std::printf("Liquid       %.4e m3, worst relative change of the total %.1e; %lld ruptures, %lld formations\n",
              f.liquid_volume, f.worst_liquid, static_cast<long long>(f.ruptures),
              static_cast<long long>(f.formations));
  std::printf("Validity     bridges made beyond the range of the law: %lld capillary, %lld rupture\n",
              static_cast<long long>(f.outside_capillary_law), static_cast<long long>(f.outside_rupture_law));
  std::printf("Energy       imbalance %.2e J of %.2e J turned over (%.1e)\n", f.imbalance, f.turnover,
              relative_imbalance(f));
  std::printf("Cost         %.1f s in all on %d threads, %.1f ns per grain and step in the test\n", f.wall_time,
              f.threads, ns_per_grain_and_step(f));
  for (const auto& line : f.limits) std::printf("Limit        %s\n", line.c_str());
  for (const auto& line : f.departures) std::printf("Departure    %s\n", line.c_str());
}

void write_summary(const job_options& o, const json& summary) {
  pendular::io::atomic_file file(o.output / "summary.json");  // where it is, the job has come to its end
  file.write(summary.dump(2) + '\n');
  file.commit();
}

}  // namespace examples
