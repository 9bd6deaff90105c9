// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/liquid/protocol/concepts.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace pendular {

/// Gaps of the listed pairs in this step and in the one before, m.
struct gap_history {
  std::span<const double> now;
  std::span<const double> before;
};

/// Read-only look at the listed pairs and their grains, as the liquid needs it.
struct pair_view {
  std::span<const std::int32_t> first, second;  // rows of the grains, padded
  std::size_t pairs;                            // without padding
  std::span<const vector> position;             // m
  std::span<const double> radius;               // m
  std::span<const std::int64_t> id;
  vector up;  // unit vector against gravity, or 0

  std::size_t grain_i(std::size_t p) const { return static_cast<std::size_t>(first[p]); }
  std::size_t grain_j(std::size_t p) const { return static_cast<std::size_t>(second[p]); }

  std::pair<std::int64_t, std::int64_t> ids(std::size_t p) const { return {id[grain_i(p)], id[grain_j(p)]}; }

  double gap(std::size_t p) const {
    const vector d = position[grain_j(p)] - position[grain_i(p)];
    return norm(d) - radius[grain_i(p)] - radius[grain_j(p)];
  }

  bridge<double> bridge_of(std::size_t p, double gap, double volume) const {
    return {gap, volume, radius[grain_i(p)], radius[grain_j(p)]};
  }

  /// The pair as grain `own` of it sees it.
  bond_side side(std::size_t p, std::size_t own, bool forming) const {
    const std::size_t partner = own == grain_i(p) ? grain_j(p) : grain_i(p);
    const vector d = position[partner] - position[own];
    const double distance = norm(d);
    const double lever = 0.5 * (distance + radius[own] - radius[partner]);
    return {radius[own], radius[partner], lever / distance * dot(d, up), id[partner], forming};
  }
};

}  // namespace pendular
