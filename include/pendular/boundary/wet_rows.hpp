// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/pair_view.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace pendular::boundary {

/// visit(wall, its contacts, its place) for the walls of a scene that carry bridges, in the order they were given.
template <class Rows, class Visit>
void for_each_wet_wall(const Rows& rows, const Visit& visit) {
  std::int32_t place = 0;
  rows.for_each_wall([&](const auto& wall, const auto& contacts) {
    if constexpr (std::remove_cvref_t<decltype(contacts)>::carries_bridges) visit(wall, contacts, place);
    ++place;
  });
}

/// The grains near these walls, as rows of the bonds after those of the pairs.
template <class Rows, class Grains>
void append_wet_rows(const Rows& rows, const Grains& g, pair_view& view) {
  for_each_wet_wall(rows, [&](const auto& wall, const auto& contacts, std::int32_t place) {
    contacts.append_rows(g, wall, place, view);
  });
}

/// Gaps of pairs and of grains near walls in one piece, for a scene that has such walls.
struct joined_gaps {
  std::vector<double> now, before;  // m

  gap_history history() const { return {now, before}; }

  void add(const gap_history& part) {
    now.insert(now.end(), part.now.begin(), part.now.end());
    before.insert(before.end(), part.before.begin(), part.before.end());
  }
};

template <class Rows>
joined_gaps gaps_of_all_rows(const Rows& rows) {
  joined_gaps all;
  all.add(rows.contacts().gaps());
  for_each_wet_wall(rows, [&](const auto&, const auto& contacts, std::int32_t) { all.add(contacts.gaps()); });
  return all;
}

}  // namespace pendular::boundary
