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

/// The lists of a result whose lengths are not known beforehand.
template <class Result, class Visit>
void for_each_list(Result& r, const Visit& visit) {
  visit(r.reference);
  visit(r.records);
  if constexpr (requires { r.relaxation; }) visit(r.relaxation);
}
}  // namespace detail

/// What a scene has found so far, in its checkpoint. A result has `reference`, `records`, perhaps `relaxation`, and a
/// `for_each_number` beside it.
template <class Result>
void save(io::checkpoint_writer& out, const Result& r) requires requires {
  r.records;
}
{
  std::vector<double> numbers;
  for_each_number(r, [&](const double& v) { numbers.push_back(v); });
  std::vector<std::int64_t> lengths;
  detail::for_each_list(r, [&](const auto& list) { lengths.push_back(static_cast<std::int64_t>(list.size())); });
  out.put("scene.lengths", lengths);
  out.put("scene.numbers", numbers);
}

template <class Result>
void load(const io::checkpoint_reader& in, Result& r) requires requires {
  r.records;
}
{
  const auto numbers = in.get<std::vector<double>>("scene.numbers");
  const auto lengths = in.get<std::vector<std::int64_t>>("scene.lengths");
  std::size_t n = 0, k = 0;
  detail::for_each_list(r, [&](auto& list) { list.resize(static_cast<std::size_t>(lengths.at(n++))); });
  for_each_number(r, [&](double& v) { v = numbers.at(k++); });
}

}  // namespace pendular::scene
