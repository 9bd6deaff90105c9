// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pendular {

/// A pair that might receive liquid.
struct candidate {
  std::size_t pair;
  bridge<double> geometry;        // volume not used
  std::pair<std::int64_t, std::int64_t> ids;

  /// R^3 of Eq. 14, R = sqrt(R_i R_j), m3.
  double size() const { return std::pow(geometry.radius_i * geometry.radius_j, 1.5); }
};

/// Eq. 14 solved: V_b = alpha R^3 for the eligible pairs.
struct homogeneous_share {
  double alpha = 0;                   // V_b / R^3
  std::vector<std::size_t> eligible;  // positions in the candidate list
};

/// No bridge wider than this is looked for, V_b / R^3: far beyond the pendular state, it only bounds the search.
inline constexpr double widest_bridge = 0.5;

/// The alpha = V_b / R^3 at which the rupture distance of a pair equals its gap; 0 in contact, infinite if it is above
/// widest_bridge. The rupture distance must grow with volume.
template <RuptureLaw Rupture>
double joining_alpha(const Rupture& rupture, const fluid& f, const candidate& c) {
  if (c.geometry.gap <= 0) return 0;
  const double size = c.size();
  const auto reaches = [&](double alpha) {
    bridge<double> b = c.geometry;
    b.volume = alpha * size;
    return rupture.distance(b, f) >= c.geometry.gap;
  };
  double low = 0, high = widest_bridge;
  if (!reaches(high)) return HUGE_VAL;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) return high;
    (reaches(middle) ? high : low) = middle;
  }
}

/// Eqs. 13-14 with their implicit eligibility (the rupture distance depends on the volume, which depends on the number
/// of eligible pairs): pairs sorted by joining alpha, longest prefix all of whose members are eligible at
/// alpha = liquid volume / sum R^3. Exact, no iteration, no cycle (docs/explanation/liquid.md).
template <RuptureLaw Rupture>
homogeneous_share share_homogeneously(const Rupture& rupture, const fluid& f, const std::vector<candidate>& candidates,
                                      double liquid_volume) {
  std::vector<std::pair<double, std::size_t>> by_alpha(candidates.size());
  for (std::size_t k = 0; k < candidates.size(); ++k) by_alpha[k] = {joining_alpha(rupture, f, candidates[k]), k};
  std::sort(by_alpha.begin(), by_alpha.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : candidates[a.second].ids < candidates[b.second].ids;
  });
  homogeneous_share share;
  double sizes = 0;
  for (const auto& [joining, k] : by_alpha) {
    const double with_this = sizes + candidates[k].size();
    if (joining > liquid_volume / with_this) break;
    sizes = with_this;
    share.eligible.push_back(k);
  }
  if (sizes > 0) share.alpha = liquid_volume / sizes;
  return share;
}

}  // namespace pendular
