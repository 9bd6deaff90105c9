// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/observe/pairs.hpp>

#include <range/v3/algorithm/count_if.hpp>

#include <cstddef>

namespace pendular::observe {

/// Mean numbers of neighbours per grain, z = 2 N / N_grains, walls not counted.
struct coordination {
  double contacts;      // touching
  double bridges;       // joined by liquid, touching or not
  double open_bridges;  // joined by liquid across a gap
};

namespace detail {
template <class Pairs, class Counts>
double mean_neighbours(Pairs pairs, std::size_t grains, const Counts& counts) {
  return 2.0 * static_cast<double>(::ranges::count_if(pairs, counts)) / static_cast<double>(grains);
}
}  // namespace detail

/// Of a system whose forces have been evaluated.
template <class System>
coordination coordination_of(const System& s) {
  const auto all = pairs(s);
  const std::size_t grains = s.particles().size();
  const auto open = [](const pair& p) { return bridged(p) && !touching(p); };
  return {detail::mean_neighbours(all, grains, touching), detail::mean_neighbours(all, grains, bridged),
          detail::mean_neighbours(all, grains, open)};
}

/// Of the neighbours that attract a grain by their total normal force. Dearer than the others: it looks at forces.
template <class System>
double tensile_coordination(const System& s) {
  return detail::mean_neighbours(pairs(s), s.particles().size(), [](const pair& p) { return p.push() < 0; });
}

}  // namespace pendular::observe
