// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/force.hpp>
#include <pendular/core/lanes.hpp>
#include <pendular/liquid/bonds.hpp>

#include <cstddef>

namespace pendular {

namespace detail {
/// Of grain j or the wall, which is infinite in a contact and finite in a bridge.
inline block bridge_radius_j(const block& radius_i, const block& radius_j) {
  return min(radius_j, wall_radius(radius_i));
}

/// The bridge resists as a dashpot beside the contact, after the Coulomb limit was taken. The contact itself may be
/// without friction and then does not know its slip.
template <class Bonds>
void add_viscous(const Bonds& bonds, std::size_t row, const encounter<block>& e, contact_force<block>& f) {
  const auto& a = e.approaching;
  const block radius_j = bridge_radius_j(a.radius_i, a.radius_j);
  const bridge_resistance<block> r = bonds.resistance(row, a.gap, a.radius_i, radius_j);
  const block push = r.normal * a.closing_speed;
  f.push += push;
  f.damping += push;
  f.slip_rate = tangential_part(e.velocity, e.normal) + e.rolling;
  f.traction -= r.tangential * f.slip_rate;
}
}  // namespace detail

/// What the bridges of a block of rows do: their viscous resistance is added to the contact force, the answer is their
/// pull, N.
template <class Bonds>
block add_bridges(const Bonds& bonds, std::size_t row, const encounter<block>& e, contact_force<block>& f) {
  if (!bonds.any_bonded(row)) return block(0.0);
  if constexpr (Bonds::is_viscous) detail::add_viscous(bonds, row, e, f);
  return bonds.attraction(row, e.approaching.gap);
}

}  // namespace pendular
