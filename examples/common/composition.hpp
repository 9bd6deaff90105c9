// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wet_options.hpp"

#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/protocol/one_of.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace examples {

/// Contact of the companion paper with a friction law.
template <class Friction>
auto contact(const wet_options& o, const Friction& friction) {
  using namespace pendular;
  return material{normal::linear{o.stiffness}, damping::viscous{0.8}, friction, energy_book{}};
}

// Friction laws with the coefficient 0.4 of the paper.
inline pendular::friction::coulomb_spring spring_friction(const wet_options& o) { return {0.8 * o.stiffness, 0.4}; }
inline pendular::friction::viscous_coulomb viscous_friction(const wet_options& o) {
  return {o.tangential_viscosity, 0.4};
}
inline pendular::friction::viscous_coulomb_explicit explicit_viscous_friction(const wet_options& o) {
  return {o.tangential_viscosity, 0.4};
}

inline pendular::fluid water(const wet_options& o) {
  return {o.surface_tension_force / (2 * std::numbers::pi), 0.0, 1000.0, 1e-3};  // theta = 0, companion paper
}

/// Liquid of a broken bridge stays on its grains: `protocol::none` as one of several.
struct stay_on_grains {
  double offer(const pendular::bond_side&) const { return 0; }
  double merge(double, double) const { return 0; }
  double settle(double, double) const { return 0; }
  double pull(const pendular::bond_side&, double) const { return 0; }
};

using local_protocol = pendular::protocol::one_of<pendular::protocol::neighbours, pendular::protocol::grain_films,
                                                  pendular::protocol::gravity, stay_on_grains>;

inline local_protocol chosen_protocol(const wet_options& o) {
  using namespace pendular::protocol;
  if (o.protocol == "neighbours") return local_protocol(neighbours{});
  if (o.protocol == "grain-films") return local_protocol(grain_films{});
  if (o.protocol == "gravity") return local_protocol(gravity{});
  return local_protocol(stay_on_grains{});
}

inline pendular::protocol::homogeneous chosen_period(const wet_options& o) {
  return {std::max<std::int64_t>(1, std::llround(5e-3 / o.time_step))};
}

/// go(liquid) with the two laws and the protocol of the options.
template <class Law, class Rupture, class Go>
void with_protocol(const wet_options& o, const Law& law, const Rupture& rupture, const Go& go) {
  using pendular::liquid;
  if (o.protocol != "homogeneous") return go(liquid{water(o), law, rupture, chosen_protocol(o)});
  go(liquid{water(o), law, rupture, chosen_period(o)});
}

}  // namespace examples
