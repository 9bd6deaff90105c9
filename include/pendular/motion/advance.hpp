// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action.hpp>
#include <pendular/contact/grain_rows.hpp>
#include <pendular/contact/wall_loads.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace pendular {

inline constexpr std::size_t grain_chunk = 512;

/// First half of a step: positions, velocities extrapolated as the integrator has it, and the rows the pairs read. True
/// if a grain has moved farther than `allowed` from where it was listed, or is nowhere.
template <class Grains, class Integration>
bool predict(Grains& g, grain_rows<Grains::rotate>& rows, const Integration& integrator,
             std::span<const vector> listed_at, double allowed) {
  const auto position = g.template get<column::position>();
  const auto velocity = g.template get<column::velocity>();
  const auto force = g.template get<column::force>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  rows.resize(g.size());
  std::vector<char> far(chunk_count(g.size(), grain_chunk), 0);
  for_chunks(g.size(), grain_chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
    bool any_far = false;
    for (std::size_t k = begin; k < end; ++k) {
      integrator.predict(position[k], velocity[k], inverse_mass[k] * force[k] + integrator.gravity);
      const vector d = position[k] - listed_at[k];
      any_far |= !(dot(d, d) < allowed * allowed);
    }
    if constexpr (Grains::rotate) {
      const auto spin = g.template get<column::angular_velocity>();
      const auto torque = g.template get<column::torque>();
      const auto inverse_inertia = g.template get<column::inverse_inertia>();
      for (std::size_t k = begin; k < end; ++k) integrator.predict_spin(spin[k], inverse_inertia[k] * torque[k]);
    }
    rows.fill(g, begin, end);
    far[c] = any_far ? 1 : 0;
  });
  return std::find(far.begin(), far.end(), 1) != far.end();
}

namespace detail {
// Force and contacts of a pair as its first and as its second grain feel them.
inline constexpr quad sides[2]{{1, 1, 1, 1}, {-1, -1, -1, 1}};

/// Sum over the pairs of a grain, in the order of the partners' ids, added to what walls do. A pair that does not act adds
/// zeros. Vectors are put together in memory: g++ 12 takes some that are listed number by number from wrong places
/// (AVX-512, -O2).
inline quad sum_pairs(const pair_list& list, const quad* actions, std::size_t row, double /*radius*/,
                      const quad& walls) {
  four_doubles sum, side, push;
  read(sum, walls);
  for (const auto& incidence : list.pairs_of(row)) {
    read(side, sides[incidence.is_second]);
    read(push, actions[incidence.pair]);
    sum += side * push;
  }
  quad all;
  write(sum, all);
  return all;
}

/// The same with torques, which take the lever arm of the grain; what stands in their fourth place means nothing. On its
/// own, so that the loop has the registers to itself.
[[gnu::noinline]] inline octet sum_pairs(const pair_list& list, const octet* actions, std::size_t row, double radius,
                                         const octet& walls) {
  four_doubles force, torque, side, push, turn;
  read(force, walls.low);
  read(torque, walls.high);
  for (const auto& incidence : list.pairs_of(row)) {
    const octet& pair = actions[incidence.pair];
    read(side, sides[incidence.is_second]);
    read(push, pair.low);
    read(turn, pair.high);
    force += side * push;
    torque += (radius + 0.5 * pair.high.d) * turn;
  }
  octet all;
  write(force, all.low);
  write(torque, all.high);
  return all;
}
}  // namespace detail

/// Second half of a step: sum of the forces of all pairs and walls on every grain, and the corrected velocities.
/// `moving` is false at the start, when forces are only stored.
template <class Grains, class Contacts, class Integration>
void correct(Grains& g, const pair_list& list, const Contacts& contacts, const wall_loads<Grains>& loads,
             const Integration& integrator, bool moving) {
  const auto velocity = g.template get<column::velocity>();
  const auto force = g.template get<column::force>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  const auto radius = g.template get<column::radius>();
  for_chunks(g.size(), grain_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto sum = detail::sum_pairs(list, contacts.actions(), k, radius[k], loads.on(k));
      const vector total = vector_of(push_of(sum));
      const vector before = inverse_mass[k] * force[k] + integrator.gravity;
      const vector now = inverse_mass[k] * total + integrator.gravity;
      if (moving) integrator.correct(velocity[k], before, now);
      force[k] = total;
      if constexpr (Grains::rotate) {
        const auto torque = g.template get<column::torque>();
        const double inverse_inertia = g.template get<column::inverse_inertia>()[k];
        auto& spin = g.template get<column::angular_velocity>()[k];
        if (moving) integrator.correct(spin, inverse_inertia * torque[k], inverse_inertia * vector_of(sum.high));
        torque[k] = vector_of(sum.high);
      }
      if constexpr (Grains::count_contacts) g.template get<column::contacts>()[k] = sum.low.d;
    }
  });
}

}  // namespace pendular
