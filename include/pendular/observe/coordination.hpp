// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <range/v3/algorithm/count_if.hpp>
#include <range/v3/view/iota.hpp>

#include <cstddef>
#include <cstdint>

namespace pendular::observe {

/// Mean numbers of neighbours per grain, z = 2 N / N_grains, walls not counted.
struct coordination {
  double contacts;     // touching
  double bridges;      // joined by liquid, touching or not
  double open_bridges; // joined by liquid across a gap
};

/// Of a system whose forces have been evaluated.
template <class System>
coordination coordination_of(const System& s) {
  const auto view = s.view();
  const auto gap = s.contacts().gap();
  const auto pairs = ::ranges::views::iota(std::int64_t{0}, static_cast<std::int64_t>(view.pairs));
  const auto mean = [&](const auto& counts) {
    const auto number = static_cast<std::int64_t>(::ranges::count_if(pairs, counts));
    return 2.0 * static_cast<double>(number) / static_cast<double>(s.particles().size());
  };
  coordination z{mean([&](auto p) { return gap[static_cast<std::size_t>(p)] < 0; }), 0, 0};
  if constexpr (System::wet) {
    const auto bonded = [&](auto p) { return s.bridges().is_bonded(static_cast<std::size_t>(p)); };
    z.bridges = mean(bonded);
    z.open_bridges = mean([&](auto p) { return bonded(p) && gap[static_cast<std::size_t>(p)] >= 0; });
  }
  return z;
}

}  // namespace pendular::observe
