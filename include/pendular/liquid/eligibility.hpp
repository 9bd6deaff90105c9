// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/host.hpp>
#include <pendular/law/concepts.hpp>
#include <pendular/liquid/bond_size.hpp>

#include <algorithm>
#include <array>
#include <bit>
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
  bool counts = true;  // on this part of the scene

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
template <Host H = alone>
alpha_range possible_alpha(const std::vector<candidate>& candidates, double liquid_volume, const H& host = {}) {
  std::array<reproducible_sum, 2> sums;
  auto& [all, touching] = sums;
  for (const candidate& c : candidates) {
    if (!c.counts) continue;
    all.add(c.size());
    if (c.geometry.gap <= 0) touching.add(c.size());
  }
  host.sum(sums);
  alpha_range range;
  if (touching.value() > 0) range.high = std::min(liquid_volume / touching.value(), widest_bridge);
  // A hair lower, so that round-off cannot decide about a pair.
  if (all.value() > 0) range.low = std::min(liquid_volume / all.value() * (1 - 1e-9), range.high);
  return range;
}

namespace detail {

/// When a candidate joins the distribution: at which alpha, and by its ids among those that join together.
struct joining {
  double alpha;
  std::pair<std::int64_t, std::int64_t> ids;
  std::size_t at;  // in the list of candidates

  friend bool operator<(const joining& a, const joining& b) {
    return a.alpha != b.alpha ? a.alpha < b.alpha : a.ids < b.ids;
  }
};

/// The candidates that have joined by some point of their order, which is that of the whole scene: a part knows its own, and
/// the sum of R^3 is that over all parts.
template <Host H>
class joined {
 public:
  joined(const std::vector<candidate>& all, std::vector<joining> in_order, const H& host)
      : all_(all), in_order_(std::move(in_order)), host_(host) {}

  /// Whether the liquid is enough for those that have joined and those that `joins` says, which is true for the first of the
  /// others and false for the rest, at this alpha. They have joined then.
  template <class Joins>
  bool take_if_enough(double liquid_volume, double alpha, const Joins& joins) {
    std::size_t end = begin_;
    reproducible_sum with_these = size_;
    for (; end < in_order_.size() && joins(in_order_[end]); ++end) add(with_these, in_order_[end]);
    if (alpha > liquid_volume / total(host_, with_these)) return false;
    begin_ = end;
    size_ = with_these;
    return true;
  }

  /// Of the first that has not joined on any part; infinite if there is none.
  double next_alpha() const { return -host_.most(begin_ < in_order_.size() ? -in_order_[begin_].alpha : -HUGE_VAL); }
  /// How many join at this alpha.
  double count_at(double alpha) const {
    reproducible_sum count;
    for (std::size_t k = begin_; k < in_order_.size() && in_order_[k].alpha == alpha; ++k) {
      if (all_[in_order_[k].at].counts) count.add(1);
    }
    return total(host_, count);
  }

  double size() const { return total(host_, size_); }
  std::vector<std::size_t> members() const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < begin_; ++k) found.push_back(in_order_[k].at);
    return found;
  }

 private:
  void add(reproducible_sum& sum, const joining& j) const {
    if (all_[j.at].counts) sum.add(all_[j.at].size());
  }

  const std::vector<candidate>& all_;
  std::vector<joining> in_order_;
  const H& host_;
  std::size_t begin_ = 0;  // of those that have not joined
  reproducible_sum size_;
};

/// The largest number in [low, high) that `holds`, which is monotone and true for low: by halving what is between.
template <class Holds>
std::uint64_t last_that_holds(std::uint64_t low, std::uint64_t high, const Holds& holds) {
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// Where not all that join together at the next alpha find enough liquid: the first of them by their ids.
template <Host H>
void take_some_of_next(joined<H>& prefix, double liquid_volume) {
  constexpr std::uint64_t ids = std::uint64_t{1} << 62;
  constexpr std::int64_t lowest = -(std::int64_t{1} << 32);  // below that of any wall
  const double next = prefix.next_alpha();
  if (!(next < HUGE_VAL) || prefix.count_at(next) < 2) return;
  const auto enough_before = [&](std::uint64_t first, std::int64_t second) {
    const std::pair end{static_cast<std::int64_t>(first), second};
    return prefix.take_if_enough(liquid_volume, next, [&](const joining& j) { return j.alpha <= next && j.ids < end; });
  };
  const std::uint64_t first = last_that_holds(0, ids, [&](std::uint64_t id) { return enough_before(id, lowest); });
  last_that_holds(0, ids,
                  [&](std::uint64_t id) { return enough_before(first, lowest + static_cast<std::int64_t>(id)); });
}

}  // namespace detail

/// Eqs. 13-14 with their implicit eligibility (the rupture distance depends on the volume, which depends on the number
/// of eligible pairs): pairs sorted by joining alpha and ids, longest prefix all of whose members are eligible at
/// alpha = liquid volume / sum R^3. Exact, no cycle (docs/explanation/liquid.md). The end of the prefix is found by halving,
/// with nothing but sums over all parts of the scene, so that no part has to know the pairs of another.
template <RuptureLaw Rupture, Host H = alone>
homogeneous_share share_homogeneously(const Rupture& rupture, const fluid& f, const std::vector<candidate>& candidates,
                                      double liquid_volume, const H& host = {}) {
  using detail::joining;
  const alpha_range range = possible_alpha(candidates, liquid_volume, host);
  std::vector<joining> in_order;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const double alpha = joining_alpha(rupture, f, candidates[k], range);
    if (alpha < HUGE_VAL) in_order.push_back({alpha, candidates[k].ids, k});
  }
  std::sort(in_order.begin(), in_order.end());
  detail::joined prefix(candidates, std::move(in_order), host);

  // All that join at an alpha at which the liquid is enough for all that have joined by then. Numbers that are not negative
  // stand in the order of their bits.
  constexpr auto beyond = std::bit_cast<std::uint64_t>(2 * widest_bridge);
  detail::last_that_holds(0, beyond, [&](std::uint64_t bits) {
    const double alpha = std::bit_cast<double>(bits);
    return prefix.take_if_enough(liquid_volume, alpha, [&](const joining& j) { return j.alpha <= alpha; });
  });
  detail::take_some_of_next(prefix, liquid_volume);

  homogeneous_share share;
  share.eligible = prefix.members();
  std::sort(share.eligible.begin(), share.eligible.end(),
            [&](std::size_t a, std::size_t b) { return candidates[a].ids < candidates[b].ids; });
  const double sizes = prefix.size();
  if (sizes > 0) share.alpha = liquid_volume / sizes;
  return share;
}

}  // namespace pendular
