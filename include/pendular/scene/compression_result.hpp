// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/observe/energy.hpp>

#include <cstdint>
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
  std::vector<compression_record> records;
};

namespace detail {
/// All numbers of a result in one fixed order.
template <class Result, class Visit>
void for_each_number(Result& r, const Visit& visit) {
  for (auto* v :
       {&r.sealed_height, &r.solid_fraction, &r.initial_bridges, &r.relaxed_bridges, &r.surface_before,
        &r.centre_before, &r.surface_settlement, &r.centre_settlement, &r.unbalanced_force, &r.start_height}) {
    visit(*v);
  }
  auto& e = r.energy_at_start;
  for (auto* v : {&e.kinetic, &e.gravity, &e.elastic, &e.friction_springs, &e.capillary, &e.damping, &e.friction,
                  &e.liquid, &e.walls}) {
    visit(*v);
  }
  for (auto& p : r.reference) for_each_scalar<double>(p, visit);
  for (auto& line : r.records) for_each_scalar<double>(line, visit);
}
}  // namespace detail

inline void save(io::checkpoint_writer& out, const compression_result& r) {
  std::vector<double> numbers;
  detail::for_each_number(r, [&](const double& v) { numbers.push_back(v); });
  out.put("scene.references", static_cast<std::uint64_t>(r.reference.size()));
  out.put("scene.records", static_cast<std::uint64_t>(r.records.size()));
  out.put("scene.numbers", numbers);
}

inline void load(const io::checkpoint_reader& in, compression_result& r) {
  const auto numbers = in.get<std::vector<double>>("scene.numbers");
  r.reference.resize(in.get<std::uint64_t>("scene.references"));
  r.records.resize(in.get<std::uint64_t>("scene.records"));
  std::size_t k = 0;
  detail::for_each_number(r, [&](double& v) { v = numbers.at(k++); });
}

}  // namespace pendular::scene
