// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box.hpp"

// How forces and torques of contacts with friction reach the grains.
namespace yardstick {

/// Of a contact, or the sum over those of a grain.
struct alignas(64) action {
  quad force;   // N
  quad torque;  // N m, or N where a lever arm is still missing; number of contacts where they are counted
};

/// What a block of pairs does to its first grains; the second ones get the opposite force, and the same torque under
/// their own lever arms.
struct action_block {
  lanes3 force, turn;  // N; turn is the torque per lever arm
  block gap, radius_i, radius_j, touching;
};

namespace detail {
inline void add(action& sum, const four& force, const four& torque) {
  whole(sum.force) += force;
  whole(sum.torque) += torque;
}

/// A wall acts on the grains of a block.
inline void add_wall(std::vector<action>& sums, const wall_rows& wall, std::size_t r, const action_block& acts) {
  const block lever = acts.radius_i + acts.gap;
  quad force[pendular::lane_count], turn[pendular::lane_count];
  pendular::store(force, {acts.force.x, acts.force.y, acts.force.z, block(0.0)});
  pendular::store(turn, {lever * acts.turn.x, lever * acts.turn.y, lever * acts.turn.z, acts.touching});
  const std::size_t real = std::min<std::size_t>(pendular::lane_count, wall.count - r);
  for (std::size_t lane = 0; lane < real; ++lane)
    add(sums[static_cast<std::size_t>(wall.grain[r + lane])], whole(force[lane]), whole(turn[lane]));
}
}  // namespace detail

/// Straight from the pair: the least work, but pairs must wait for each other, so that threads are of no use.
class straight_actions {
 public:
  void relist(const box& b) { sums_.assign(b.size(), {}); }

  void put(const pair_rows& pairs, std::size_t p, const action_block& acts) {
    const block lever_i = acts.radius_i + 0.5 * acts.gap, lever_j = acts.radius_j + 0.5 * acts.gap;
    const lanes3 on_i = lever_i * acts.turn, on_j = lever_j * acts.turn;
    quad force[pendular::lane_count], first[pendular::lane_count], second[pendular::lane_count];
    pendular::store(force, {acts.force.x, acts.force.y, acts.force.z, block(0.0)});
    pendular::store(first, {on_i.x, on_i.y, on_i.z, acts.touching});
    pendular::store(second, {on_j.x, on_j.y, on_j.z, acts.touching});
    const std::size_t real = std::min<std::size_t>(pendular::lane_count, pairs.count - p);
    for (std::size_t lane = 0; lane < real; ++lane) {
      const four f = whole(force[lane]);
      detail::add(sums_[static_cast<std::size_t>(pairs.first[p + lane])], f, whole(first[lane]));
      detail::add(sums_[static_cast<std::size_t>(pairs.second[p + lane])], -f, whole(second[lane]));
    }
  }
  void put_force(const pair_rows& pairs, std::size_t p, const lanes3& force) {
    quad row[pendular::lane_count];
    pendular::store(row, {force.x, force.y, force.z, block(0.0)});
    const std::size_t real = std::min<std::size_t>(pendular::lane_count, pairs.count - p);
    for (std::size_t lane = 0; lane < real; ++lane) {
      const four f = whole(row[lane]);
      quad& i = sums_[static_cast<std::size_t>(pairs.first[p + lane])].force;
      quad& j = sums_[static_cast<std::size_t>(pairs.second[p + lane])].force;
      whole(i) += f;
      whole(j) -= f;
    }
  }
  void put_nothing(std::size_t) {}
  void put_wall(const wall_rows& wall, std::size_t r, const action_block& acts) {
    detail::add_wall(sums_, wall, r, acts);
  }

  /// The sum of a grain, which begins anew.
  void take(const pair_rows&, const quad&, std::size_t k, four& force, four& torque) {
    force = whole(sums_[k].force);
    torque = whole(sums_[k].torque);
    sums_[k] = {};
  }

 private:
  std::vector<action> sums_;
};

/// A row for every pair, which the grains add up: what the library does, because threads may share both phases.
class listed_actions {
 public:
  void relist(const box& b) {
    of_walls_.assign(b.size(), {});
    rows_.assign(b.pairs.size(), {});
  }

  void put(const pair_rows&, std::size_t p, const action_block& acts) {
    put_forces(p, {acts.force.x, acts.force.y, acts.force.z, acts.gap});
    const quad_block torques{acts.turn.x, acts.turn.y, acts.turn.z, acts.touching};
    pendular::simd::scatter(torques, [&](int k) -> quad& { return rows_[p + static_cast<std::size_t>(k)].torque; });
  }
  /// Where the torques are 0 already.
  void put_force(const pair_rows&, std::size_t p, const lanes3& force) {
    put_forces(p, {force.x, force.y, force.z, block(0.0)});
  }
  void put_nothing(std::size_t p) { std::fill_n(&rows_[p], pendular::lane_count, action{}); }
  void put_wall(const wall_rows& wall, std::size_t r, const action_block& acts) {
    detail::add_wall(of_walls_, wall, r, acts);
  }

  void take(const pair_rows& pairs, const quad& place, std::size_t k, four& force, four& torque) {
    // A table, because a branch would be guessed wrong half of the time.
    static constexpr quad sign[2] = {{1, 1, 1, 0}, {-1, -1, -1, 0}};
    force = whole(of_walls_[k].force);
    torque = whole(of_walls_[k].torque);
    of_walls_[k] = {};
    for (std::size_t m = pairs.start[k]; m < pairs.start[k + 1]; ++m) {
      const action& row = rows_[pairs.incident[m] >> 1];
      const double lever = place.d + 0.5 * row.force.d;
      force += whole(sign[pairs.incident[m] & 1u]) * whole(row.force);
      torque += four{lever, lever, lever, 1} * whole(row.torque);
    }
  }

 private:
  void put_forces(std::size_t p, const quad_block& forces) {
    pendular::simd::scatter(forces, [&](int k) -> quad& { return rows_[p + static_cast<std::size_t>(k)].force; });
  }

  std::vector<action> of_walls_, rows_;
};

}  // namespace yardstick
