// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job.hpp"

#include <pendular/core/vec.hpp>
#include <pendular/observe/pairs.hpp>
#include <pendular/space/grains.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace examples {

/// The state of a sample, by id of the grains.
struct snapshot {
  double time;  // s
  std::vector<double> x, y, z, radius, displacement, liquid;
  std::vector<double> displacement_x, displacement_y, displacement_z;
  std::vector<std::array<std::int64_t, 2>> bonds;
  std::vector<double> bond_force, bond_volume, bond_gap;
};

/// Liquid on every grain by row, m3: its film and half of its bridges; the bridges themselves go into the snapshot.
template <class System>
std::vector<double> take_liquid(const System& s, snapshot& shot) {
  std::vector<double> liquid(s.particles().size(), 0.0);
  if constexpr (System::wet) {
    for (const pendular::observe::pair& p : pendular::observe::pairs(s)) {
      if (!pendular::observe::bridged(p)) continue;
      shot.bonds.push_back({p.ids.first, p.ids.second});
      shot.bond_force.push_back(p.push());
      shot.bond_volume.push_back(p.bridge_volume);
      shot.bond_gap.push_back(p.gap);
      liquid[p.rows.first] += 0.5 * p.bridge_volume;
      liquid[p.rows.second] += 0.5 * p.bridge_volume;
    }
    const auto films = s.bridges().book().films();
    for (std::size_t row = 0; row < liquid.size(); ++row) liquid[row] += films[row];
  }
  return liquid;
}

/// `reference` has the positions by id from which displacements count.
template <class System>
snapshot take(const System& s, const std::vector<pendular::vector>& reference, double time) {
  snapshot shot;
  shot.time = time;
  const auto liquid = take_liquid(s, shot);
  const auto& g = s.particles();
  std::size_t id = 0;
  for (const std::size_t row : g.rows_by_id()) {
    const pendular::vector x = g.template get<pendular::column::position>()[row], moved = x - reference[id++];
    shot.x.push_back(x.x), shot.y.push_back(x.y), shot.z.push_back(x.z);
    shot.displacement_x.push_back(moved.x), shot.displacement_y.push_back(moved.y);
    shot.displacement_z.push_back(moved.z);
    shot.radius.push_back(g.template get<pendular::column::radius>()[row]);
    shot.displacement.push_back(norm(moved));
    shot.liquid.push_back(liquid[row]);
  }
  return shot;
}

/// Writes the state for ParaView; the collection is rewritten so that a running job can be looked at. Number 0 begins it
/// anew; another takes the place of frames that are not before it.
void write_snapshot(const job_options& o, const snapshot& s, int number);

/// Ray-traced sample.png and section.png, coloured by displacement, if pictures are wanted.
void draw_sample(const job_options& o, const snapshot& s, double lid_height);

}  // namespace examples
