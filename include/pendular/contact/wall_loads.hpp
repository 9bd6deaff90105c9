// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pendular {

/// What walls do to the grains near them in a step, collected before the pairs are added.
template <bool Rotates>
class wall_loads {
 public:
  /// Forgets the grains of an old list.
  void relist(std::size_t grains) {
    place_.assign(grains, -1);
    loads_.clear();
  }
  template <class WallContacts>
  void list(const WallContacts& wall) {
    for (std::size_t k = 0; k < wall.size(); ++k) {
      std::int32_t& place = place_[wall.row(k)];
      if (place >= 0) continue;
      place = static_cast<std::int32_t>(loads_.size());
      loads_.push_back({});
    }
  }

  void clear() { std::fill(loads_.begin(), loads_.end(), action_row<Rotates>{}); }

  template <class WallContacts>
  void add(const WallContacts& wall) {
    const action_row<Rotates>* actions = wall.actions();
    for (std::size_t k = 0; k < wall.size(); ++k) {
      auto& sum = loads_[static_cast<std::size_t>(place_[wall.row(k)])];
      pendular::add(push_of(sum), vector_of(push_of(actions[k])), push_of(actions[k]).d);
      if constexpr (Rotates) pendular::add(sum.high, vector_of(actions[k].high), 0);
    }
  }

  /// To be kept in a local variable.
  class view {
   public:
    view(const std::int32_t* place, const action_row<Rotates>* loads) : place_(place), loads_(loads) {}
    /// On a grain, all zeros where no wall is near.
    const action_row<Rotates>& on(std::size_t row) const {
      static constexpr action_row<Rotates> nothing{};
      return place_[row] < 0 ? nothing : loads_[place_[row]];
    }

   private:
    const std::int32_t* place_;
    const action_row<Rotates>* loads_;
  };
  view by_grain() const { return {place_.data(), loads_.data()}; }

 private:
  std::vector<std::int32_t> place_;  // of a grain among the loads, or -1
  std::vector<action_row<Rotates>> loads_;
};

}  // namespace pendular
