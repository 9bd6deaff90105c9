// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/solid_fraction.hpp>
#include <pendular/scene/result_file.hpp>

#include <type_traits>
#include <vector>

namespace pendular::scene {

/// Stresses on the area of the cell, Pa.
struct shear_stresses {
  double shear;  // horizontal force that drives the upper half and the lid
  double lid;    // vertical, on the lid
  double plane;  // vertical, between the halves: all that floor and lower half bear less the weight below
};

/// A line of the shear curve.
struct shear_record {
  double time;          // since the upper half started, s
  double displacement;  // of the upper half, m
  shear_stresses stress;
  double height;    // of the lid, m
  double contacts;  // mean touching neighbours of a grain
  double bridges;   // mean liquid bridges of a grain
  double liquid;    // total over what was introduced
  struct book {
    double imbalance;  // of the energy book since the upper half started, J
    double turnover;   // of energy since the upper half started, J
  } energy;
};

/// The sample before it is sheared.
struct shear_sample {
  double deposited_height = 0;    // m
  double consolidation_time = 0;  // until friction came, s
  double solid_fraction = 0;      // when friction came
  double split_height = 0;        // of the plane between the halves, m
  double initial_bridges = 0;     // mean per grain, as distributed
  struct when_the_upper_half_starts {
    double height = 0;                 // of the lid, m
    double bridges = 0;                // mean per grain
    double unbalanced_force = 0;       // mean over the mean contact force
    double shear_stress = 0;           // on the plane between the halves, before it moves, Pa
    observe::solid_fractions density;  // the bulk is two mean diameters away from walls, floor and lid
  } start;
};

struct shear_result {
  shear_sample sample;
  observe::energies energy_at_start;
  std::vector<vector> reference;  // positions by id when the upper half starts, m
  std::vector<shear_record> records;
};

/// All numbers of a result in one fixed order.
template <class Result, class Visit>
void for_each_number(Result& r, const Visit& visit) requires std::is_same_v<std::remove_const_t<Result>, shear_result> {
  for_each_scalar<double>(r.sample, visit);
  detail::for_each_energy(r.energy_at_start, visit);
  for (auto& p : r.reference) for_each_scalar<double>(p, visit);
  for (auto& line : r.records) for_each_scalar<double>(line, visit);
}

}  // namespace pendular::scene
