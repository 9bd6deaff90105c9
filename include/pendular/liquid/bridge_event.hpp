// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace pendular {

/// What happened to a bridge: it formed; it broke because its gap grew beyond its rupture distance; it was torn, which is
/// the same within one step and so fast that its pair had left the list; it was emptied, by a sink or by hand.
enum class bridge_change { formed, broke, torn, emptied };

/// One bridge that formed or ended.
struct bridge_event {
  bridge_change what;
  std::pair<std::int64_t, std::int64_t> ids;  // of its grains, the lower first; -1 - k instead of the second for wall k
  std::size_t row;                            // among the bonds, as long as the list is not made anew
  double gap;                                 // m
  double volume;                              // of the bridge that formed, or before it ended, m3
  std::int64_t step = 0;
};

/// How many since liquid was last distributed.
struct bond_events {
  std::int64_t ruptures = 0;
  std::int64_t formations = 0;
};

}  // namespace pendular
