// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/parallel.hpp>
#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace pendular {

/// What walls do to the grains in a step, collected before the pairs are added.
template <class Grains>
struct wall_loads {
  std::vector<vector> force;     // N
  std::vector<vector> torque;    // N m; empty without friction
  std::vector<double> contacts;  // empty unless the friction law counts them

  void clear(std::size_t grains) {
    force.assign(grains, vector{0, 0, 0});
    if constexpr (Grains::rotate) torque.assign(grains, vector{0, 0, 0});
    if constexpr (Grains::count_contacts) contacts.assign(grains, 0.0);
  }

  template <class WallContacts>
  void add(const WallContacts& wall) {
    for (std::size_t k = 0; k < wall.size(); ++k) {
      const std::size_t row = wall.row(k);
      force[row] += wall.force(k);
      if constexpr (Grains::rotate) torque[row] += wall.torque(k);
      if constexpr (Grains::count_contacts) contacts[row] += wall.gap(k) < 0 ? 1.0 : 0.0;
    }
  }
};

inline constexpr std::size_t grain_chunk = 512;

/// First half of a step: positions, and velocities extrapolated as the integrator has it. True if a grain has moved
/// farther than `allowed` from where it was listed, or is nowhere.
template <class Grains, class Integration>
bool predict(Grains& g, const Integration& integrator, std::span<const vector> listed_at, double allowed) {
  const auto position = g.template get<column::position>();
  const auto velocity = g.template get<column::velocity>();
  const auto force = g.template get<column::force>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
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
    far[c] = any_far ? 1 : 0;
  });
  return std::find(far.begin(), far.end(), 1) != far.end();
}

namespace detail {
/// Sum over the pairs of a grain, in the order of the partners' ids. A pair that does not act adds zeros.
struct pair_sum {
  vector force, torque;
  double contacts;
};

template <class Grains, class Contacts>
pair_sum sum_pairs(const pair_list& list, const Contacts& contacts, std::size_t row, double radius,
                   const pair_sum& start) {
  four_doubles force{start.force.x, start.force.y, start.force.z, start.contacts};
  four_doubles torque{start.torque.x, start.torque.y, start.torque.z, 0};
  four_doubles term;
  for (const auto& incidence : list.pairs_of(row)) {
    const auto p = static_cast<std::size_t>(incidence.pair);
    const double sign = incidence.sign;
    read(term, contacts.push(p));
    force += four_doubles{sign, sign, sign, 1} * term;
    if constexpr (Grains::rotate) {
      const quad& turn = contacts.turn(p);
      const double lever = radius + 0.5 * turn.d;
      read(term, turn);
      torque += four_doubles{lever, lever, lever, 0} * term;
    }
  }
  return {{force[0], force[1], force[2]}, {torque[0], torque[1], torque[2]}, force[3]};
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
      detail::pair_sum sum{loads.force[k], {0, 0, 0}, 0};
      if constexpr (Grains::rotate) sum.torque = loads.torque[k];
      if constexpr (Grains::count_contacts) sum.contacts = loads.contacts[k];
      sum = detail::sum_pairs<Grains>(list, contacts, k, radius[k], sum);
      const vector before = inverse_mass[k] * force[k] + integrator.gravity;
      const vector now = inverse_mass[k] * sum.force + integrator.gravity;
      if (moving) integrator.correct(velocity[k], before, now);
      force[k] = sum.force;
      if constexpr (Grains::rotate) {
        const auto torque = g.template get<column::torque>();
        const double inverse_inertia = g.template get<column::inverse_inertia>()[k];
        auto& spin = g.template get<column::angular_velocity>()[k];
        if (moving) integrator.correct(spin, inverse_inertia * torque[k], inverse_inertia * sum.torque);
        torque[k] = sum.torque;
      }
      if constexpr (Grains::count_contacts) g.template get<column::contacts>()[k] = sum.contacts;
    }
  });
}

}  // namespace pendular
