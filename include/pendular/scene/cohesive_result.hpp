// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/scene/result_file.hpp>
#include <pendular/space/cell_grid.hpp>

#include <type_traits>
#include <vector>

namespace pendular::scene {

/// A wet sample at one moment of its relaxation.
struct cohesive_record {
  double time;              // since the liquid came, s
  double solid_fraction;    // over the box
  double contacts;          // mean touching neighbours of a grain
  double bridges;           // mean liquid bridges of a grain
  double unbalanced_force;  // mean over the mean force of a pair
  double wall_stress;       // mean of the six walls, Pa
  double liquid;            // total over what was introduced
  struct book {
    double imbalance;  // of the energy book since the liquid came, J
    double turnover;   // of energy since the liquid came, J
  } energy;
};

/// The box and what is in it.
struct cohesive_state {
  box room{};                 // between the walls
  double solid_fraction = 0;  // over the box
  double bulk_fraction = 0;   // two mean diameters and more away from the walls; 0 if nothing is
  double contacts = 0;        // mean per grain
  double bridges = 0;         // mean per grain
  double open_bridges = 0;    // of them across a gap
};

struct cohesive_result {
  double packing_unbalanced_force = 0;  // of the dry packing, mean over the mean contact force
  cohesive_state start;                 // when the liquid has come
  cohesive_state end;                   // when the sample is at rest, or the time is over
  observe::energies energy_at_start;
  std::vector<vector> reference;  // positions by id when the liquid comes, m
  std::vector<cohesive_record> records;
};

/// All numbers of a result in one fixed order.
template <class Result, class Visit>
void for_each_number(Result& r,
                     const Visit& visit) requires std::is_same_v<std::remove_const_t<Result>, cohesive_result> {
  visit(r.packing_unbalanced_force);
  for_each_scalar<double>(r.start, visit);
  for_each_scalar<double>(r.end, visit);
  detail::for_each_energy(r.energy_at_start, visit);
  for (auto& p : r.reference) for_each_scalar<double>(p, visit);
  for (auto& line : r.records) for_each_scalar<double>(line, visit);
}

}  // namespace pendular::scene
