// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/drive.hpp>
#include <pendular/core/reproducible_sum.hpp>

#include <cstddef>
#include <span>

namespace pendular::boundary {

/// The load of a wall, added up without an error, so that it is the same whatever the order and on all parts of a scene. Its
/// sums are those of one wall among all, which the parts join at once.
template <class Drive>
class load_sum {
  static constexpr bool force_only = HasOneVelocity<Drive>;

 public:
  static constexpr std::size_t width = force_only ? 3 : 7;

  explicit load_sum(std::span<reproducible_sum> sums) : sums_(sums) {}

  void add(const vector& force) { put(0, force); }
  void add_turn(const vector& torque, double power) requires(!force_only) {
    put(3, torque);
    sums_[6].add(power);
  }

  wall_load value() const {
    wall_load all;
    all.force = three(0);
    if constexpr (!force_only) {
      all.torque = three(3);
      all.power = sums_[6].value();
    }
    return all;
  }

 private:
  void put(std::size_t first, const vector& v) {
    sums_[first].add(v.x), sums_[first + 1].add(v.y), sums_[first + 2].add(v.z);
  }
  vector three(std::size_t first) const {
    return {sums_[first].value(), sums_[first + 1].value(), sums_[first + 2].value()};
  }

  std::span<reproducible_sum> sums_;
};

}  // namespace pendular::boundary
