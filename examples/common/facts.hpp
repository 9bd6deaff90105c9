// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job.hpp"

#include <pendular/io/number.hpp>
#include <pendular/motion/scene_check.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/fabric.hpp>
#include <pendular/observe/force_distribution.hpp>

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace examples {

/// Pairs and their forces at the end of a test.
struct network_facts {
  pendular::observe::coordination neighbours;
  double tensile = 0;                             // neighbours of a grain that attract it
  std::array<double, 3> fabric{};                 // xx, yy, zz of the contacts
  double mean_compressive = 0, mean_tensile = 0;  // forces, N
};

template <class System>
network_facts network_of(const System& s) {
  const auto forces = pendular::observe::force_distribution_of(s);
  const auto fabric = pendular::observe::fabric_tensor(s);
  return {pendular::observe::coordination_of(s),
          pendular::observe::tensile_coordination(s),
          {fabric(0, 0), fabric(1, 1), fabric(2, 2)},
          forces.mean_compressive,
          forces.mean_tensile};
}

/// What the report of a test needs besides its result.
struct run_facts {
  double wall_time = 0;  // of all stages in this program, s
  double test_time = 0;  // of the last stage in this program, s
  double test_processor_time = 0;
  std::int64_t test_steps = 0;
  double grains = 0;
  int threads = 1;
  std::int64_t ruptures = 0, formations = 0;
  std::int64_t outside_capillary_law = 0, outside_rupture_law = 0;  // bridges made beyond the validity of the laws
  double liquid_volume = 0;                                         // introduced, m3
  double largest_bridge = 0;                                        // V_b / R^3 at the end
  double mean_diameter = 0;                                         // m
  double worst_liquid = 0;                                          // change of the total over the total
  double imbalance = 0, turnover = 0;                               // of the energy book in the test, J
  std::vector<std::string> limits;                                  // of stability, as checked
  std::vector<std::string> departures;                              // from the paper
  network_facts network;                                            // at the end
  pendular::observe::energies energy_at_start, energy_at_end;
};

/// What the system knows at the end of the test.
template <class System>
run_facts facts_of(const System& s) {
  run_facts f;
  f.grains = static_cast<double>(s.particles().size());
  f.threads = thread_count();
  if constexpr (System::wet) {
    const auto view = s.view();
    f.ruptures = s.events().ruptures;
    f.formations = s.events().formations;
    f.outside_capillary_law = s.bridges().outside().capillary_law;
    f.outside_rupture_law = s.bridges().outside().rupture_law;
    f.liquid_volume = s.bridges().book().introduced();
    for (std::size_t p = 0; p < view.pairs; ++p) {
      f.largest_bridge = std::max(f.largest_bridge, s.bridges().book().bonds()[p] / s.bridges().size_of(p, view));
    }
  }
  for (const pendular::scene_limit& l : s.limits()) {
    f.limits.push_back(l.what + " " + pendular::detail::number(l.value) + ", bound " +
                       pendular::detail::number(l.bound) + (l.holds() ? "" : " BROKEN"));
  }
  f.network = network_of(s);
  f.energy_at_end = pendular::observe::energies_of(s);
  return f;
}

/// The parts of summary.json that every test has.
void put_facts(nlohmann::ordered_json& summary, const run_facts& f);

/// The same for the reader of the terminal.
void print_facts(const run_facts& f);

/// Errors: std::runtime_error if the file cannot be written.
void write_summary(const job_options& o, const nlohmann::ordered_json& summary);

}  // namespace examples
