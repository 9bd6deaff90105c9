// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pendular::observe {

/// Rows of the listed pairs, grain by grain and then by the partners' ids: a sum in this order does not depend on which
/// pairs the list holds besides, or in which order it holds them.
template <class System>
std::vector<std::size_t> pairs_in_order(const System& s) {
  std::vector<std::size_t> pairs;
  pairs.reserve(s.pairs().size());
  for (std::size_t row = 0; row < s.particles().size(); ++row) {
    for (const auto& incidence : s.pairs().pairs_of(row)) {
      if (incidence.sign > 0) pairs.push_back(static_cast<std::size_t>(incidence.pair));
    }
  }
  return pairs;
}

}  // namespace pendular::observe
