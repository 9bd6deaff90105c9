// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "packing.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/capillary/willett_closed_form.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/homogeneous.hpp>

// The scenes that are measured: a packing in its box, dry or with 1 % of its mass in water.
namespace scenes {

using namespace pendular;

constexpr double normal_stiffness = 1e3;    // k_n, N/m
constexpr double damping_rate = 0.8;        // alpha_n
constexpr double surface_tension = 0.0637;  // gamma, N/m
constexpr double water_content = 0.01;      // mass of the water over that of the grains

// A large packing is a pile of blocks that nothing holds but gravity, which presses the lowest more than a user may ask for.
inline const run_options options{.force = true};
inline const velocity_verlet integrator{1e-6, {0, 0, -9.81}};
inline const normal::linear spring{normal_stiffness};
inline const damping::viscous dashpot{damping_rate};
inline const friction::coulomb_spring sliding_spring{800, 0.4};

template <class Capillary>
auto water(const Capillary& law) {
  return liquid{fluid{surface_tension, 0, 1000, 1e-3}, law, rupture::lian{}, protocol::homogeneous{5000}};
}

template <class System>
System filled(System s, const packing::sample& sample) {
  for (const grain& g : sample.grains) s.add(g);
  if constexpr (System::wet) {
    double mass = 0;
    for (const double inverse : s.particles().template get<column::inverse_mass>()) mass += 1 / inverse;
    s.distribute_liquid(water_content * mass / 1000);
  }
  return s;
}

inline auto box(const packing::sample& sample) { return packing::box_of(sample.size, boundary::fixed{}); }

/// The paper's.
inline auto wet(const packing::sample& sample) {
  return filled(pendular::system{material{spring, dashpot, friction::viscous_coulomb{1.0, 0.4}},
                                 water(capillary::richefeu{}), box(sample), integrator, options},
                sample);
}

inline auto wet_spring(const packing::sample& sample) {
  return filled(pendular::system{material{spring, dashpot, sliding_spring, energy_book{}}, water(capillary::richefeu{}),
                                 box(sample), integrator, options},
                sample);
}

inline auto wet_willett(const packing::sample& sample) {
  return filled(pendular::system{material{spring, dashpot, sliding_spring}, water(capillary::willett_closed_form{}),
                                 box(sample), integrator, options},
                sample);
}

inline auto dry(const packing::sample& sample) {
  return filled(pendular::system{material{spring, dashpot, sliding_spring}, box(sample), integrator, options}, sample);
}

inline auto smooth(const packing::sample& sample) {
  return filled(pendular::system{material{spring, dashpot}, box(sample), integrator, options}, sample);
}

}  // namespace scenes
