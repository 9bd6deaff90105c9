// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/scene/result_file.hpp>

#include <type_traits>
#include <vector>

namespace pendular::scene {

/// A line of the stress-strain curve.
struct compression_record {
  double time;        // since the lid started, s
  double shortening;  // of the sample, m
  double stress;      // axial, on the area before the test, Pa
  double contacts;    // mean touching neighbours of a grain
  double bridges;     // mean liquid bridges of a grain
  double liquid;      // total over what was introduced
  double imbalance;   // of the energy book since the lid started, J
  double turnover;    // of energy since the lid started, J
};

/// A line of the relaxation.
struct relaxation_record {
  double time;                // since the cylinder was taken away, s
  double surface_settlement;  // m
  double centre_settlement;   // of the centre of mass, m
  double bridges;             // mean liquid bridges of a grain
};

struct compression_result {
  double sealed_height = 0;  // m
  double solid_fraction = 0;
  double initial_bridges = 0;     // mean per grain, as distributed
  double relaxed_bridges = 0;     // mean per grain, when the lid starts
  double surface_before = 0;      // height when the cylinder is taken away, m
  double centre_before = 0;       // of mass, m
  double surface_settlement = 0;  // in the relaxation, m
  double centre_settlement = 0;   // of the centre of mass in the relaxation, m
  double unbalanced_force = 0;    // after the relaxation, mean over the mean contact force
  double start_height = 0;        // of the lid when it starts, m
  observe::energies energy_at_start;
  std::vector<vector> reference;  // positions by id when the lid starts, m
  std::vector<relaxation_record> relaxation;
  std::vector<compression_record> records;
};

/// All numbers of a result in one fixed order.
template <class Result, class Visit>
void for_each_number(Result& r,
                     const Visit& visit) requires std::is_same_v<std::remove_const_t<Result>, compression_result> {
  for (auto* v :
       {&r.sealed_height, &r.solid_fraction, &r.initial_bridges, &r.relaxed_bridges, &r.surface_before,
        &r.centre_before, &r.surface_settlement, &r.centre_settlement, &r.unbalanced_force, &r.start_height}) {
    visit(*v);
  }
  detail::for_each_energy(r.energy_at_start, visit);
  for (auto& p : r.reference) for_each_scalar<double>(p, visit);
  for (auto& line : r.relaxation) for_each_scalar<double>(line, visit);
  for (auto& line : r.records) for_each_scalar<double>(line, visit);
}

}  // namespace pendular::scene
