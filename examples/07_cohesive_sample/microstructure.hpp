// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/observe/exponential_decay.hpp>
#include <pendular/observe/force_distribution.hpp>
#include <pendular/observe/grain_pressures.hpp>
#include <pendular/observe/pair_signs.hpp>
#include <pendular/scene/box_walls.hpp>
#include <pendular/scene/cohesive_result.hpp>
#include <pendular/space/grains.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// Pairs and pressures of a sample as the companion paper looks at them, and what it prints.
struct microstructure {
  pendular::observe::force_distribution forces;
  double largest_over_f0 = 0;                                 // compressive force
  pendular::observe::exponential_decay compressive, tensile;  // of |f| / f0, in `compressive_window`, `tensile_window`
  std::vector<pendular::observe::pair_signs> signs;           // by id
  std::vector<pendular::observe::pair_signs> bulk;            // away from the walls
  std::vector<double> pressures;                              // by id, Pa
  double solid_fraction = 0;                                  // that the pressures are taken with

  static constexpr pendular::observe::decay_window compressive_window{0.25, 2}, tensile_window{0.25, 1};
};

/// Means over grains.
struct mean_neighbours {
  double compressive = 0, tensile = 0;
  double all() const { return compressive + tensile; }
};

inline mean_neighbours mean_of(const std::vector<pendular::observe::pair_signs>& signs) {
  mean_neighbours mean;
  for (const auto& k : signs) mean.compressive += k.compressive, mean.tensile += k.tensile;
  const double grains = signs.empty() ? 1 : static_cast<double>(signs.size());
  return {mean.compressive / grains, mean.tensile / grains};
}

/// Where rho(k+, k-) is largest.
inline std::array<int, 2> peak_of(const Eigen::MatrixXd& shares) {
  std::array<int, 2> peak{-1, -1};
  if (shares.size() > 0) shares.maxCoeff(&peak[0], &peak[1]);
  return peak;
}

/// Of the grains that are two mean diameters and more away from all walls.
template <class System>
std::vector<pendular::observe::pair_signs> bulk_of(const System& s, const pendular::box& room,
                                                   const std::vector<pendular::observe::pair_signs>& signs) {
  using namespace pendular;
  const auto position = s.particles().template get<column::position>();
  const auto radius = s.particles().template get<column::radius>();
  double margin = 0;
  for (const double r : radius) margin += 4 * r / static_cast<double>(radius.size());
  std::vector<observe::pair_signs> inside;
  std::size_t id = 0;
  for (const std::size_t row : s.particles().rows_by_id()) {
    const vector low = position[row] - room.lower, high = room.upper - position[row];
    const double nearest = std::min({low.x, low.y, low.z, high.x, high.y, high.z});
    if (nearest >= margin) inside.push_back(signs[id]);
    ++id;
  }
  return inside;
}

/// `largest_pull` is f0, N.
template <class System>
microstructure microstructure_of(const System& s, const pendular::scene::cohesive_state& state, double largest_pull) {
  using namespace pendular;
  microstructure m;
  m.forces = observe::force_distribution_of(s);
  for (const double f : m.forces.compressive) m.largest_over_f0 = std::max(m.largest_over_f0, f / largest_pull);
  m.compressive = observe::exponential_decay_of(m.forces.compressive, largest_pull, microstructure::compressive_window);
  m.tensile = observe::exponential_decay_of(m.forces.tensile, largest_pull, microstructure::tensile_window);
  m.signs = observe::pair_signs_of(s);
  m.bulk = bulk_of(s, state.room, m.signs);
  m.solid_fraction = state.bulk_fraction > 0 ? state.bulk_fraction : state.solid_fraction;
  m.pressures = observe::grain_pressures(s, m.solid_fraction);
  return m;
}
