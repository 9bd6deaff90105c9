// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../scenes.hpp"
#include "../stopwatch.hpp"
#include "measurement.hpp"

#include <algorithm>

namespace peers {

/// One of our scenes, made anew: every code measures the same steps of the packing.
template <class Make>
measurement measured(const packing::sample& sample, int warmup, int steps, const Make& make) {
  namespace column = pendular::column;
  const double grains = static_cast<double>(sample.grains.size());
  auto s = make(sample);
  s.run(warmup);
  measurement m{};
  m.time = 1e9 * processor_time([&] { s.run(steps); }) / steps / grains;
  const auto gap = s.contacts().gap().first(s.pairs().size());
  m.contacts = static_cast<double>(std::count_if(gap.begin(), gap.end(), [](double g) { return g < 0; })) / grains;
  if constexpr (decltype(s)::wet) m.bridges = static_cast<double>(s.bridges().count()) / grains;
  const auto velocity = s.particles().template get<column::velocity>();
  const auto inverse_mass = s.particles().template get<column::inverse_mass>();
  for (std::size_t k = 0; k < velocity.size(); ++k)
    m.kinetic_energy += 0.5 * dot(velocity[k], velocity[k]) / inverse_mass[k] / grains;
  return m;
}

}  // namespace peers
