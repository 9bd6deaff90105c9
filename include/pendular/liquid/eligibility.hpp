// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>
#include <pendular/liquid/bond_size.hpp>

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
  bridge<double> geometry;  // volume not used
  std::pair<std::int64_t, std::int64_t> ids;

  /// R^3 of Eq. 14, m3.
  double size() const { return bond_size(geometry); }
};

/// Eq. 14 solved: V_b = alpha R^3 for the eligible pairs.
struct homogeneous_share {
  double alpha = 0;                   // V_b / R^3
  std::vector<std::size_t> eligible;  // positions in the candidate list
};

/// No bridge wider than this is looked for, V_b / R^3: far beyond the pendular state, it only bounds the search.
inline constexpr double widest_bridge = 0.5;

/// Bounds between which a joining alpha has to be known.
struct alpha_range {
  double low = 0, high = widest_bridge;  // V_b / R^3
};

/// The alpha = V_b / R^3 at which the rupture distance of a pair equals its gap: 0 if that is at or below the range,
/// infinite if above. The rupture distance must grow with volume.
template <RuptureLaw Rupture>
double joining_alpha(const Rupture& rupture, const fluid& f, const candidate& c, alpha_range range = {}) {
  const double size = c.size();
  const auto reaches = [&](double alpha) {
    bridge<double> b = c.geometry;
    b.volume = alpha * size;
    return rupture.distance(b, f) >= c.geometry.gap;
  };
  if (c.geometry.gap <= 0 || (range.low > 0 && reaches(range.low))) return 0;
  if (!reaches(range.high)) return HUGE_VAL;
  while (true) {
    const double middle = 0.5 * (range.low + range.high);
    if (!(range.low < middle && middle < range.high)) return range.high;
    (reaches(middle) ? range.high : range.low) = middle;
  }
}

/// The alpha of the whole distribution is not below that of all candidates together and not above that of the touching
/// ones alone: most pairs are in or out without a search.
inline alpha_range possible_alpha(const std::vector<candidate>& candidates, double liquid_volume) {
  double all = 0, touching = 0;
  for (const candidate& c : candidates) {
    all += c.size();
    touching += c.geometry.gap <= 0 ? c.size() : 0.0;
  }
  alpha_range range;
  if (touching > 0) range.high = std::min(liquid_volume / touching, widest_bridge);
  // A hair lower, so that the order of the sum cannot decide about a pair.
  if (all > 0) range.low = std::min(liquid_volume / all * (1 - 1e-9), range.high);
  return range;
}

/// Eqs. 13-14 with their implicit eligibility (the rupture distance depends on the volume, which depends on the number
/// of eligible pairs): pairs sorted by joining alpha, longest prefix all of whose members are eligible at
/// alpha = liquid volume / sum R^3. Exact, no iteration, no cycle (docs/explanation/liquid.md).
template <RuptureLaw Rupture>
homogeneous_share share_homogeneously(const Rupture& rupture, const fluid& f, const std::vector<candidate>& candidates,
                                      double liquid_volume) {
  std::vector<std::pair<double, std::size_t>> by_alpha(candidates.size());
  const alpha_range range = possible_alpha(candidates, liquid_volume);
  for (std::size_t k = 0; k < candidates.size(); ++k)
    by_alpha[k] = {joining_alpha(rupture, f, candidates[k], range), k};
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
  // Summed once more by ids: the order above depends on the range, and that on how many pairs the list happens to hold.
  std::sort(share.eligible.begin(), share.eligible.end(),
            [&](std::size_t a, std::size_t b) { return candidates[a].ids < candidates[b].ids; });
  sizes = 0;
  for (const std::size_t k : share.eligible) sizes += candidates[k].size();
  if (sizes > 0) share.alpha = liquid_volume / sizes;
  return share;
}

}  // namespace pendular
