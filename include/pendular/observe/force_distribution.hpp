// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/observe/pairs.hpp>

#include <range/v3/numeric/accumulate.hpp>

#include <cstddef>
#include <vector>

namespace pendular::observe {

/// Sizes of the normal forces of all pairs, N, in the order of the ids of their grains. Pairs without force are left
/// out, as in Richefeu et al. 2006 (Eur. Phys. J. E 21, 359), Figs. 2 and 10; walls are not counted.
struct force_distribution {
  std::vector<double> compressive;  // of pairs that repel each other
  std::vector<double> tensile;      // of pairs that attract each other, positive too
  double mean_compressive = 0;      // N; 0 if there is none
  double mean_tensile = 0;
};

namespace detail {
inline double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : ::ranges::accumulate(values, 0.0) / static_cast<double>(values.size());
}
}  // namespace detail

/// Of a system whose forces have been evaluated.
template <class System>
force_distribution force_distribution_of(const System& s) {
  force_distribution f;
  for (const double push : pairs(s) | ::ranges::views::transform(push_of)) {
    if (push > 0) f.compressive.push_back(push);
    if (push < 0) f.tensile.push_back(-push);
  }
  f.mean_compressive = detail::mean(f.compressive);
  f.mean_tensile = detail::mean(f.tensile);
  return f;
}

}  // namespace pendular::observe
