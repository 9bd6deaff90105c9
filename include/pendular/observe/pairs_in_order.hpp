// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pendular::observe {

/// Rows of the listed pairs in the order of the ids of their grains: a sum in this order does not depend on which pairs
/// the list holds besides, or on how grains and pairs are stored.
template <class System>
std::vector<std::size_t> pairs_in_order(const System& s) {
  std::vector<std::size_t> pairs;
  pairs.reserve(s.pairs().size());
  for (const std::size_t row : s.particles().rows_by_id()) {
    for (const auto& incidence : s.pairs().pairs_of(row)) {
      if (!incidence.is_second) pairs.push_back(static_cast<std::size_t>(incidence.pair));
    }
  }
  return pairs;
}

}  // namespace pendular::observe
