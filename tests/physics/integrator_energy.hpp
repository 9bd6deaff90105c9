// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "integrator_scenes.hpp"

#include <chrono>

// What integrators do to the energy, conserved and booked.
namespace integrator_energy {

using namespace integrator_scenes;

/// Largest distance of the energy from its first value, over that, in the first and the last tenth of a run.
struct swing {
  double early, late;
};

/// Two elastic grains pressed together between two plates, out of balance: contacts that never open, so that nothing
/// hides a drift.
template <class Integration>
swing elastic_pair(double steps, int periods) {
  const double r = 0.5e-3, k = 1e3, squeeze = 1e-5, dt = pi * std::sqrt(0.5 * sphere_mass(r, 2600) / k) / steps;
  const boundary::walls plates{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                               boundary::wall{boundary::plane{{0, 0, 4 * r - 3 * squeeze}, {0, 0, -1}}}};
  pendular::system s{material{normal::linear{k}, pendular::energy_book{}}, plates, Integration{dt},
                     run_options{.force = true}};
  s.add({{0, 0, r - squeeze}, r, 2600, {0, 0, 3e-2}});
  s.add({{0, 0, 3 * r - 2 * squeeze}, r, 2600, {0, 0, -1e-2}});
  s.start();
  const double energy = pendular::observe::energies_of(s).balance();
  swing w{0, 0};
  const auto total = static_cast<std::int64_t>(2 * steps * periods);
  for (std::int64_t n = 0; n < total; n += 7) {
    s.run(7);
    double& part = n < total / 10 ? w.early : w.late;
    if (n < total / 10 || n > total - total / 10) {
      part = std::max(part, std::abs(pendular::observe::energies_of(s).balance() / energy - 1));
    }
  }
  return w;
}

struct book {
  double imbalance;  // over the energy that went through
  double step_time;  // of the clock on the wall, s
};

/// 125 dry grains thrown together and sheared for 30 ms between plates in counter-motion.
template <class Integration>
book sheared_packing(double steps, std::uint64_t seed) {
  const double r = 0.5e-3, k = 1e3, side = 6.2e-3;
  const double dt = pi * std::sqrt(0.5 * sphere_mass(r, 2600) / k) / steps;
  using boundary::constant_velocity;
  using boundary::plane;
  using boundary::wall;
  const boundary::walls cell{wall{plane{{0, 0, 0}, {1, 0, 0}}},
                             wall{plane{{side, 0, 0}, {-1, 0, 0}}},
                             wall{plane{{0, 0, 0}, {0, 1, 0}}},
                             wall{plane{{0, side, 0}, {0, -1, 0}}},
                             wall{plane{{0, 0, 0}, {0, 0, 1}}, constant_velocity{{0.3, 0, 0}}},
                             wall{plane{{0, 0, 6.1e-3}, {0, 0, -1}}, constant_velocity{{-0.3, 0, -0.04}}}};
  pendular::system s{
      material{normal::linear{k}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, pendular::energy_book{}},
      cell, Integration{dt, {0, 0, -9.81}}, run_options{.force = true}};
  for (const pendular::grain& g : loose_lattice(5, 5, 5, r, 0.08, 1.2e-3, 0.6, seed)) s.add(g);
  s.start();
  const auto before = pendular::observe::energies_of(s);
  const auto total = std::llround(0.03 / dt);
  const auto clock = std::chrono::steady_clock::now();
  s.run(total);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - clock;
  const auto after = pendular::observe::energies_of(s);
  return {(after.balance() - before.balance()) / after.turnover_since(before),
          took.count() / static_cast<double>(total)};
}

/// Root mean square of the imbalance over some seeds: the scene is chaotic, and one run says little.
template <class Integration>
book sheared_packings(double steps, int seeds) {
  book mean{0, std::numeric_limits<double>::infinity()};
  for (int n = 0; n < seeds; ++n) {
    const book one = sheared_packing<Integration>(steps, 12345u + 77u * static_cast<std::uint64_t>(n));
    mean.imbalance += one.imbalance * one.imbalance / seeds;
    mean.step_time = std::min(mean.step_time, one.step_time);
  }
  mean.imbalance = std::sqrt(mean.imbalance);
  return mean;
}

}  // namespace integrator_energy
