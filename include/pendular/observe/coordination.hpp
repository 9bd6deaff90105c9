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
};

namespace detail {
template <class System, class Counts>
double mean_neighbours(const System& s, const Counts& counts) {
  return 2.0 * static_cast<double>(::ranges::count_if(indices(s.view().pairs), counts)) /
         static_cast<double>(s.particles().size());
}
}  // namespace detail

/// Of a system whose forces have been evaluated.
template <class System>
coordination coordination_of(const System& s) {
  const auto gap = s.contacts().gap();
  coordination z{detail::mean_neighbours(s, [&](std::size_t p) { return gap[p] < 0; }), 0, 0};
  if constexpr (System::wet) {
    const auto bonded = [&](std::size_t p) { return s.bridges().is_bonded(p); };
    z.bridges = detail::mean_neighbours(s, bonded);
    z.open_bridges = detail::mean_neighbours(s, [&](std::size_t p) { return bonded(p) && gap[p] >= 0; });
  }
  return z;
}

/// Of the neighbours that attract a grain by their total normal force. Dearer than the others: it looks at forces.
template <class System>
double tensile_coordination(const System& s) {
  const auto view = s.view();
  return detail::mean_neighbours(s, [&](std::size_t p) { return normal_force(s, view, p) < 0; });
}

}  // namespace pendular::observe
