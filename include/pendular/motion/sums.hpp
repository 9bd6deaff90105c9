// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/space/pair_list.hpp>

#include <span>

namespace pendular {

namespace detail {
// Force and contacts of a pair as its first and as its second grain feel them.
inline constexpr quad sides[2]{{1, 1, 1, 1}, {-1, -1, -1, 1}};

/// Sum over the pairs of a grain, in the order of the partners' ids, added to what walls do. A pair that does not act adds
/// zeros.
inline quad sum_pairs(std::span<const pair_list::incidence> pairs, const quad* actions, double /*radius*/,
                      const quad& walls) {
  four sum = load_row(walls);
  for (const auto& incidence : pairs) {
    sum += load_row(sides[incidence.is_second]) * load_row(actions[incidence.pair]);
  }
  quad all;
  store_row(all, sum);
  return all;
}

/// The same with torques, which take the lever arm of the grain; what stands in their fourth place means nothing.
inline octet sum_pairs(std::span<const pair_list::incidence> pairs, const octet* actions, double radius,
                       const octet& walls) {
  four force = load_row(walls.low), torque = load_row(walls.high);
  for (const auto& incidence : pairs) {
    const octet& pair = actions[incidence.pair];
    force += load_row(sides[incidence.is_second]) * load_row(pair.low);
    torque += (radius + 0.5 * pair.high.d) * load_row(pair.high);
  }
  octet all;
  store_row(all.low, force);
  store_row(all.high, torque);
  return all;
}
}  // namespace detail

}  // namespace pendular
