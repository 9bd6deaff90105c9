// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/liquid/pair_view.hpp>
#include <pendular/observe/indices.hpp>
#include <pendular/observe/pairs_in_order.hpp>

#include <range/v3/view/transform.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace pendular::observe {

/// Two listed grains, near each other, touching or joined by liquid, as an observer sees them.
struct pair {
  std::pair<std::int64_t, std::int64_t> ids;  // the lower first
  std::pair<std::size_t, std::size_t> rows;   // of the two grains
  std::size_t row;                            // of the pair: of its contact and of its bridge
  double gap;                                 // m, negative in overlap
  double radius_i, radius_j;                  // m
  vector branch;                              // from the centre of the first to that of the second, m
  vector force;                               // on the first, N: contact, damping, friction and bridge together
  double bridge_volume;                       // m3; 0 without a bridge

  /// Unit vector from the first to the second.
  vector normal() const { return (1 / norm(branch)) * branch; }
  /// Normal force, N, repulsion positive.
  double push() const { return -dot(force, normal()); }
};

// What views are composed of: pairs(s) | filter(touching) | transform(push_of).
inline constexpr auto touching = [](const pair& p) { return p.gap < 0; };
inline constexpr auto bridged = [](const pair& p) { return p.bridge_volume > 0; };
inline constexpr auto push_of = [](const pair& p) { return p.push(); };

/// A view of all listed pairs in the order of the ids of their grains: what is computed from it depends neither on threads
/// nor on the neighbour list. Valid until the system changes. Errors: forces that have not been evaluated.
template <class System>
auto pairs(const System& s) {
  s.expect_evaluated("an observer of pairs");
  struct looked_at {
    pair_view view;
    std::vector<std::size_t> rows;
  };
  const auto all = std::make_shared<const looked_at>(looked_at{s.view(), pairs_in_order(s)});
  const auto look = [all, &s](std::size_t k) {
    const pair_view& v = all->view;
    const std::size_t p = all->rows[k], i = v.grain_i(p), j = v.grain_j(p);
    double volume = 0;
    if constexpr (System::wet) volume = s.bridges().book().bonds()[p];
    return pair{v.ids(p),
                {i, j},
                p,
                s.contacts().gap()[p],
                v.radius[i],
                v.radius[j],
                v.position[j] - v.position[i],
                s.contacts().force(p),
                volume};
  };
  return indices(all->rows.size()) | ::ranges::views::transform(look);
}

}  // namespace pendular::observe
