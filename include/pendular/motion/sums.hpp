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
/// zeros. Vectors are put together in memory: g++ 12 takes some that are listed number by number from wrong places
/// (AVX-512, -O2).
inline quad sum_pairs(std::span<const pair_list::incidence> pairs, const quad* actions, double /*radius*/,
                      const quad& walls) {
  four_doubles sum, side, push;
  read(sum, walls);
  for (const auto& incidence : pairs) {
    read(side, sides[incidence.is_second]);
    read(push, actions[incidence.pair]);
    sum += side * push;
  }
  quad all;
  write(sum, all);
  return all;
}

/// The same with torques, which take the lever arm of the grain; what stands in their fourth place means nothing.
inline octet sum_pairs(std::span<const pair_list::incidence> pairs, const octet* actions, double radius,
                       const octet& walls) {
  four_doubles force, torque, side, push, turn;
  read(force, walls.low);
  read(torque, walls.high);
  for (const auto& incidence : pairs) {
    const octet& pair = actions[incidence.pair];
    read(side, sides[incidence.is_second]);
    read(push, pair.low);
    read(turn, pair.high);
    force += side * push;
    torque += (radius + 0.5 * pair.high.d) * turn;
  }
  octet all;
  write(force, all.low);
  write(torque, all.high);
  return all;
}
}  // namespace detail

}  // namespace pendular
