// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/space/graded_grid.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular {

/// How far grains may go before the list must be made anew.
struct listing {
  std::span<const grain_row::place> at;  // where they were listed
  double allowed;                        // m
};

/// The list of the pairs of a scene's grains, and whether it still holds.
class neighbourhood {
 public:
  const pair_list& list() const { return list_; }
  double skin() const { return skin_; }  // m
  std::int64_t rebuild_count() const { return rebuilds_; }

  listing listed() const { return {listed_at_, 0.5 * skin_}; }
  /// A grain is too far from where it was listed, or pairs may act that are too far apart for the list.
  void expire(bool now = true) { stale_ |= now; }
  /// A wall has come nearer by at most this way, m.
  void wall_came(double way) { wall_travel_ += way; }
  bool is_stale() const { return stale_ || wall_travel_ > 0.5 * skin_; }

  /// Nothing is left of the list, because all grains are new.
  void forget() { list_ = {}; }

  /// How the rows of a new list follow from those of the old.
  struct origins {
    std::vector<std::int32_t> of_pairs;  // row in the old list, or -1
    std::vector<std::size_t> of_grains;  // row before
  };

  /// Stores the grains in spatial order and lists their pairs that are within `range` of each other, the skin included,
  /// both m. Grains marked as gone are taken out.
  template <class Grains>
  origins relist(Grains& g, double range, double skin, std::span<const char> gone = {}) {
    skin_ = skin;
    std::vector<std::size_t> kept;
    for (std::size_t row = 0; row < g.size(); ++row) {
      if (gone.empty() || gone[row] == 0) kept.push_back(row);
    }
    if (kept.size() < g.size()) g.permute(kept);
    const graded_grid grid(g.template get<column::position>(), g.template get<column::radius>(), range, g.kept());
    const auto order = grid.order(g.template get<column::id>());
    g.permute(order);
    origins from;
    for (const std::size_t row : order) from.of_grains.push_back(kept[row]);
    from.of_pairs = list_.rebuild(g.template get<column::position>(), g.template get<column::radius>(),
                                  g.template get<column::id>(), grid, range, range - skin, from.of_grains);
    const auto places = g.template rows<grain_row::place>();
    listed_at_.assign(places.begin(), places.end());
    wall_travel_ = 0;
    stale_ = false;
    ++rebuilds_;
    return from;
  }

 private:
  pair_list list_;
  std::vector<grain_row::place> listed_at_;
  double skin_ = 0, wall_travel_ = 0;
  std::int64_t rebuilds_ = 0;
  bool stale_ = true;
};

}  // namespace pendular
