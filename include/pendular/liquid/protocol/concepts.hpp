// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/liquid/door_archetype.hpp>

#include <concepts>
#include <cstdint>

namespace pendular {

/// What a redistribution protocol sees of a bond from one of its two grains.
struct bond_side {
  double own_radius;      // m
  double partner_radius;  // m
  double contact_height;  // of the contact point above the own centre, against gravity, m
  std::int64_t partner;   // id of the other grain
  bool forming;           // a new contact of this step that has no liquid yet
};

/// Redistribution among the bonds of one grain, in three moves that do not depend on the order of the bonds:
/// every bond offers, the offers of a grain are merged, `settle` turns merged offer and film into a grant, and every
/// bond pulls its volume from the grant. The pulls of a grain never exceed its film.
template <class P>
concept LocalProtocol = Copyable<P> && requires(const P p, const bond_side side, const double film) {
  p.merge(p.offer(side), p.offer(side));
  p.settle(p.offer(side), film);
  { p.pull(side, p.settle(p.offer(side), film)) } -> std::convertible_to<double>;
};

/// Redistribution over the whole scene, once per period (steps), through a liquid_door. May say by `reach(door)` how far
/// apart the pairs are that it needs in the list, m.
template <class P>
concept GlobalProtocol = Copyable<P> && requires(const P p, liquid_door_archetype& door) {
  { p.period } -> std::convertible_to<std::int64_t>;
  p.redistribute(door);
};

template <class P>
concept Protocol = LocalProtocol<P> || GlobalProtocol<P>;

}  // namespace pendular
