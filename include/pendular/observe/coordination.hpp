// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/observe/indices.hpp>
#include <pendular/observe/normal_force.hpp>

#include <range/v3/algorithm/count_if.hpp>

#include <cstddef>

namespace pendular::observe {

/// Mean numbers of neighbours per grain, z = 2 N / N_grains, walls not counted.
struct coordination {
  double contacts;      // touching
  double bridges;       // joined by liquid, touching or not
  double open_bridges;  // joined by liquid across a gap
  double tensile;       // attracting each other by their total normal force
};

/// Of a system whose forces have been evaluated.
template <class System>
coordination coordination_of(const System& s) {
  const auto view = s.view();
  const auto gap = s.contacts().gap();
  const auto mean = [&](const auto& counts) {
    return 2.0 * static_cast<double>(::ranges::count_if(indices(view.pairs), counts)) /
           static_cast<double>(s.particles().size());
  };
  coordination z{mean([&](std::size_t p) { return gap[p] < 0; }), 0, 0,
                 mean([&](std::size_t p) { return normal_force(s, view, p) < 0; })};
  if constexpr (System::wet) {
    const auto bonded = [&](std::size_t p) { return s.bridges().is_bonded(p); };
    z.bridges = mean(bonded);
    z.open_bridges = mean([&](std::size_t p) { return bonded(p) && gap[p] >= 0; });
  }
  return z;
}

}  // namespace pendular::observe
