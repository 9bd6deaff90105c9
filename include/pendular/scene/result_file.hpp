// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/checkpoint.hpp>
#include <pendular/observe/energy.hpp>

#include <cstdint>
#include <vector>

namespace pendular::scene {

namespace detail {
template <class Energies, class Visit>
void for_each_energy(Energies& e, const Visit& visit) {
  for (auto* v : {&e.kinetic, &e.gravity, &e.elastic, &e.friction_springs, &e.capillary, &e.damping, &e.friction,
                  &e.liquid, &e.walls}) {
    visit(*v);
  }
}
}  // namespace detail

/// What a scene has found so far, in its checkpoint. A result has `reference`, `records` and a
/// `for_each_number` beside it.
template <class Result>
void save(io::checkpoint_writer& out, const Result& r) requires requires {
  r.records;
}
{
  std::vector<double> numbers;
  for_each_number(r, [&](const double& v) { numbers.push_back(v); });
  out.put("scene.references", static_cast<std::uint64_t>(r.reference.size()));
  out.put("scene.records", static_cast<std::uint64_t>(r.records.size()));
  out.put("scene.numbers", numbers);
}

template <class Result>
void load(const io::checkpoint_reader& in, Result& r) requires requires {
  r.records;
}
{
  const auto numbers = in.get<std::vector<double>>("scene.numbers");
  r.reference.resize(in.get<std::uint64_t>("scene.references"));
  r.records.resize(in.get<std::uint64_t>("scene.records"));
  std::size_t k = 0;
  for_each_number(r, [&](double& v) { v = numbers.at(k++); });
}

}  // namespace pendular::scene
