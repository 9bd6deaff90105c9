// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box.hpp"

// How the forces of frictionless contacts reach the grains.
namespace yardstick {

/// Straight from the pair: the least work, but pairs must wait for each other, so that threads are of no use.
class straight_forces {
 public:
  void relist(const box& b) { sums_.assign(b.size(), {}); }

  void put(const pair_rows& pairs, std::size_t p, const lanes3& force) {
    quad row[pendular::lane_count];
    pendular::store(row, {force.x, force.y, force.z, block(0.0)});
    const std::size_t real = std::min<std::size_t>(pendular::lane_count, pairs.count - p);
    for (std::size_t lane = 0; lane < real; ++lane) {
      const four f = whole(row[lane]);
      quad& i = sums_[static_cast<std::size_t>(pairs.first[p + lane])];
      quad& j = sums_[static_cast<std::size_t>(pairs.second[p + lane])];
      whole(i) += f;
      whole(j) -= f;
    }
  }
  void put_nothing(std::size_t) {}
  double& along(std::size_t axis, std::size_t k) { return (&sums_[k].a)[axis]; }

  /// The sum of a grain, which begins anew.
  void take(const pair_rows&, std::size_t k, four& sum) {
    sum = whole(sums_[k]);
    sums_[k] = {};
  }

 private:
  std::vector<quad> sums_;
};

/// A row for every pair, which the grains add up: what the library does, because threads may share both phases.
class listed_forces {
 public:
  void relist(const box& b) {
    of_walls_.assign(b.size(), {});
    rows_.assign(b.pairs.size(), {});
    busy_.assign(b.pairs.size() / pendular::lane_count, 0);
  }

  void put(const pair_rows&, std::size_t p, const lanes3& force) {
    pendular::store(rows_.data() + p, {force.x, force.y, force.z, block(0.0)});
    busy_[p / pendular::lane_count] = 1;
  }
  void put_nothing(std::size_t p) {
    char& busy = busy_[p / pendular::lane_count];
    if (busy != 0) std::fill_n(rows_.data() + p, pendular::lane_count, quad{});
    busy = 0;
  }
  double& along(std::size_t axis, std::size_t k) { return (&of_walls_[k].a)[axis]; }

  void take(const pair_rows& pairs, std::size_t k, four& sum) {
    static constexpr double sign[2] = {1,
                                       -1};  // from a table, because a branch would be guessed wrong half of the time
    sum = whole(of_walls_[k]);
    of_walls_[k] = {};
    for (std::size_t m = pairs.start[k]; m < pairs.start[k + 1]; ++m) {
      sum += sign[pairs.incident[m] & 1u] * whole(rows_[pairs.incident[m] >> 1]);
    }
  }

 private:
  std::vector<quad> of_walls_, rows_;
  std::vector<char> busy_;
};

}  // namespace yardstick
