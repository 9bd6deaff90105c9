// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/extremes.hpp>
#include <pendular/core/host.hpp>
#include <pendular/liquid/bonds.hpp>
#include <pendular/liquid/eligibility.hpp>
#include <pendular/liquid/selection.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

namespace detail {

/// V_i = V D_i / (D_i + D_j) to the film of i, the rest to that of j (Richefeu et al. 2007, section 3.2). A wall keeps no
/// film: all that it shared with a grain stays on the grain.
template <class Liquid>
void break_bond(bonds<Liquid>& b, bridge_change how, std::size_t p, double gap, const pair_view& view) {
  const std::size_t i = view.grain_i(p);
  b.note(how, p, gap, b.book().bonds()[p], view);
  if (view.is_at_wall(p)) {
    b.drain(p, ledger::film_of(i), gap, view);
    return;
  }
  const std::size_t j = view.grain_j(p);
  const double share = b.book().bonds()[p] * (view.radius[i] / (view.radius[i] + view.radius[j]));
  b.move(ledger::bond_of(p), ledger::film_of(i), share, p, gap, view);
  b.drain(p, ledger::film_of(j), gap, view);
}

/// A volume on its way from the film of a grain to a bond.
struct pull {
  std::size_t pair;
  std::size_t grain;
  double volume;  // m3
};

/// visit(row) for all rows of a grain: its pairs by the partners' ids, then its walls.
template <class PairsOf, class Visit>
void for_each_row_of(std::size_t grain, const pair_view& view, const PairsOf& pairs_of, const Visit& visit) {
  for (const auto& incidence : pairs_of(grain)) visit(static_cast<std::size_t>(incidence.pair));
  view.for_each_wall_row_of(grain, visit);
}

/// What a local protocol does in a step. Offers are merged and settled where a grain is kept, grants go to its copies, and
/// bonds pull wherever they are.
template <class Liquid, class PairsOf>
class film_round {
  using protocol_type = typename Liquid::protocol_type;

 public:
  using grant = decltype(std::declval<protocol_type>().settle(std::declval<protocol_type>().offer(bond_side{}), 0.0));

  film_round(const bonds<Liquid>& b, const pair_view& view, const gap_history& gap, const PairsOf& pairs_of)
      : bonds_(b), view_(view), gap_(gap), pairs_of_(pairs_of), protocol_(b.policies().redistribution()) {}

  /// Of a grain that is kept here and has a film; none if none of its bonds can receive.
  std::optional<grant> settle(std::size_t grain) const {
    std::optional<decltype(protocol_.offer(bond_side{}))> merged;
    for_each_receiver(grain, [&](std::size_t p) {
      const auto offer = protocol_.offer(side(p, grain));
      merged = merged ? protocol_.merge(*merged, offer) : offer;
    });
    if (!merged) return {};
    return protocol_.settle(*merged, bonds_.free_film(grain, view_));
  }
  /// Answers all that the bonds of the grain pull here, m3.
  double pull_from(std::size_t grain, const grant& granted, std::vector<pull>& pulls) const {
    double sum = 0;
    for_each_receiver(grain, [&](std::size_t p) {
      const double volume = protocol_.pull(side(p, grain), granted);
      if (!(volume > 0)) return;
      pulls.push_back({p, grain, volume});
      sum += volume;
    });
    return sum;
  }

 private:
  template <class Visit>
  void for_each_receiver(std::size_t grain, const Visit& visit) const {
    for_each_row_of(grain, view_, pairs_of_, [&](std::size_t p) {
      if (bonds_.is_bonded(p) || bonds_.forms(p, gap_.now[p], gap_.before[p])) visit(p);
    });
  }
  bond_side side(std::size_t p, std::size_t grain) const { return view_.side(p, grain, !bonds_.is_bonded(p)); }

  const bonds<Liquid>& bonds_;
  const pair_view& view_;
  const gap_history& gap_;
  const PairsOf& pairs_of_;
  protocol_type protocol_;
};

/// The grant of a grain.
template <class Grant>
struct granted {
  std::size_t grain;
  Grant grant;
};

/// Adds those of the grains of which there are copies here.
template <class Grant, Host H>
void share_grants(std::vector<granted<Grant>>& all, const pair_view& view, const H& host) {
  if constexpr (is_distributed<H>) {
    static_assert(
        std::is_trivially_copyable_v<Grant>,
        "what a protocol's `settle` answers is sent to other parts of the scene and must be trivially copyable "
        "(docs/reference/host.md)");
    constexpr std::size_t width = 1 + (sizeof(Grant) + sizeof(double) - 1) / sizeof(double);
    std::vector<double> numbers(width * view.radius.size(), 0.0);
    for (const auto& g : all) {
      numbers[width * g.grain] = 1;
      std::memcpy(&numbers[width * g.grain + 1], &g.grant, sizeof(Grant));
    }
    host.update_copies(numbers, width);
    for (std::size_t grain = view.kept; grain < view.radius.size(); ++grain) {
      if (numbers[width * grain] == 0) continue;
      std::array<std::byte, sizeof(Grant)> bytes;
      std::memcpy(bytes.data(), &numbers[width * grain + 1], sizeof(Grant));
      all.push_back({grain, std::bit_cast<Grant>(bytes)});
    }
  }
}

/// Whether all that is pulled into a pair makes a bridge there: enough liquid, and not beyond its own rupture distance.
template <class Liquid>
bool makes_bond(const bonds<Liquid>& b, std::size_t p, double volume, double gap, const pair_view& view) {
  if (b.is_bonded(p)) return true;
  const auto formation = b.policies().formation();
  if (volume < formation.minimum_volume * b.size_of(p, view)) return false;
  return gap < formation.reach(b.policies().rupture_distance(view.bridge_of(p, gap, volume)));
}

/// Pulls sorted by the ids of pair and grain, carried out pair by pair.
template <class Liquid>
void carry_out(bonds<Liquid>& b, std::vector<pull>& pulls, const pair_view& view, std::span<const double> gap) {
  const auto key = [&](const pull& a) { return std::pair{view.ids(a.pair), view.id[a.grain]}; };
  std::sort(pulls.begin(), pulls.end(), [&](const pull& a, const pull& c) { return key(a) < key(c); });
  for (std::size_t k = 0; k < pulls.size();) {
    std::size_t end = k;
    double volume = 0;
    for (; end < pulls.size() && pulls[end].pair == pulls[k].pair; ++end) volume += pulls[end].volume;
    const std::size_t p = pulls[k].pair;
    if (makes_bond(b, p, volume, gap[p], view)) {
      if (!b.is_bonded(p)) b.note(bridge_change::formed, p, gap[p], volume, view);
      for (std::size_t m = k; m < end; ++m) {
        // By the reservoir: the bond gets the same volume on every part. What the pulls of a grain exceed its film by, which is
        // round-off and known to its keeper alone, is then the reservoir's.
        b.move(ledger::reservoir(), ledger::bond_of(p), pulls[m].volume, p, gap[p], view);
        b.drain_film(pulls[m].grain, ledger::reservoir(), pulls[m].volume, view);
      }
      b.made(p, view);
    }
    k = end;
  }
}

/// New thresholds for the pairs without a bridge of all grains whose film has changed.
template <class Liquid, class PairsOf>
void refresh_dry_pairs(bonds<Liquid>& b, std::vector<std::size_t> grains, const pair_view& view,
                       const PairsOf& pairs_of) {
  std::sort(grains.begin(), grains.end());
  grains.erase(std::unique(grains.begin(), grains.end()), grains.end());
  for (const std::size_t grain : grains) {
    for_each_row_of(grain, view, pairs_of, [&](std::size_t p) {
      if (!b.is_bonded(p)) b.refresh(p, view);
    });
  }
}

/// These bridges, in the order of their ids.
template <class Liquid, class GapOf>
void break_in_order(bonds<Liquid>& b, bridge_change how, std::vector<std::size_t> rows, const pair_view& view,
                    const GapOf& gap_of) {
  view.sort_by_ids(rows);
  for (const std::size_t p : rows) break_bond(b, how, p, gap_of(p), view);
}

/// All bridges beyond their rupture distance.
template <class Liquid, class PairsOf, Host H>
void break_bonds(bonds<Liquid>& b, const pair_view& view, std::span<const double> gap, const PairsOf& pairs_of,
                 const H& host) {
  std::vector<std::size_t> broken;
  view.for_each_row([&](std::size_t p) {
    if (b.breaks(p, gap[p])) broken.push_back(p);
  });
  break_in_order(b, bridge_change::broke, broken, view, [&](std::size_t p) { return gap[p]; });
  std::vector<std::size_t> grains = b.mirror_films(view, host);
  for (const std::size_t p : broken) view.for_each_grain_of(p, [&](std::size_t grain) { grains.push_back(grain); });
  refresh_dry_pairs(b, std::move(grains), view, pairs_of);
}

inline void expect_drawn(double pulled, double film) {
  constexpr double round_off = 1 + 1e-12, dust = 1e-290;  // m3; products of what is left of films may be subnormal
  if (!(pulled > film * round_off + dust)) return;
  throw run_error(
      "a redistribution protocol pulled more from a grain than its film: what it settles must be enough for all "
      "pulls (see docs/how-to/own_protocol.md)");
}

/// Films into bonds, as a local protocol has it.
template <class Liquid, class PairsOf, Host H>
void share_films(bonds<Liquid>& b, const pair_view& view, const gap_history& gap, const PairsOf& pairs_of,
                 const H& host) {
  const film_round<Liquid, PairsOf> round(b, view, gap, pairs_of);
  std::vector<granted<typename film_round<Liquid, PairsOf>::grant>> grants;
  together(host, [&] {
    for (std::size_t grain = 0; grain < view.kept; ++grain) {
      if (!(b.free_film(grain, view) > 0)) continue;
      if (const auto grant = round.settle(grain)) grants.push_back({grain, *grant});
    }
  });
  share_grants(grants, view, host);
  std::vector<pull> pulls;
  together(host, [&] {
    for (const auto& g : grants) {
      const double pulled = round.pull_from(g.grain, g.grant, pulls);
      if (view.keeps(g.grain)) expect_drawn(pulled, b.book().films()[g.grain]);
    }
  });
  std::vector<std::size_t> drained;
  for (const auto& p : pulls) drained.push_back(p.grain);
  carry_out(b, pulls, view, gap.now);
  for (const std::size_t grain : b.mirror_films(view, host)) drained.push_back(grain);
  refresh_dry_pairs(b, std::move(drained), view, pairs_of);
}
}  // namespace detail

/// Bridges torn in one step beyond the range of the list that is about to be made break here, before they lose their
/// pair; all others wait for settle_bonds.
template <class Liquid>
void break_torn_bonds(bonds<Liquid>& b, const pair_view& view, double range) {
  std::vector<std::size_t> torn;
  view.for_each_row([&](std::size_t p) {
    if (b.is_bonded(p) && view.gap(p) >= range) torn.push_back(p);
  });
  detail::break_in_order(b, bridge_change::torn, torn, view, [&](std::size_t p) { return view.gap(p); });
  if (!torn.empty()) b.ask_protocol();
}

/// Ruptures and formations of one step: bridges beyond their rupture distance give their liquid to the films of their
/// grains, then a local protocol moves films into bonds. `pairs_of(grain)` lists the pairs of a grain by partner id,
/// so the result depends neither on the order of the pairs nor on the number of threads or parts.
template <class Liquid, class PairsOf, Host H = alone>
void settle_bonds(bonds<Liquid>& b, const pair_view& view, const gap_history& gap, const PairsOf& pairs_of,
                  const H& host = {}) {
  b.ask_protocol(false);
  detail::break_bonds(b, view, gap.now, pairs_of, host);
  if constexpr (Liquid::redistributes_locally) detail::share_films(b, view, gap, pairs_of, host);
}

namespace detail {
/// The sum over all grains of the scene of something that a radius has.
template <class Size, Host H>
double sum_over_grains(const pair_view& view, const Size& size, const H& host) {
  reproducible_sum sizes;
  for (std::size_t g = 0; g < view.kept; ++g) sizes.add(size(view.radius[g]));
  return pendular::total(host, sizes);
}

/// Films in proportion to the size that a grain of a radius has.
template <class Liquid, class Size, Host H>
void spread_over_grains(bonds<Liquid>& b, const pair_view& view, double volume, const Size& size, const H& host) {
  const double sizes = sum_over_grains(view, size, host);
  for (std::size_t g = 0; g < view.radius.size(); ++g) {
    b.fill_film(ledger::reservoir(), g, volume * (size(view.radius[g]) / sizes), view);
  }
}

/// The films that the roughness of the grains holds, in proportion to their surface if there is not enough for all.
/// Answers what is left for bridges, m3.
template <class Liquid, Host H>
double fill_roughness(bonds<Liquid>& b, const pair_view& view, double volume, const H& host) {
  const auto held = [&](double r) { return b.selection().held_film(r); };
  const double wanted = sum_over_grains(view, held, host);
  if (wanted == 0) return volume;
  spread_over_grains(b, view, std::min(volume, wanted), held, host);
  return std::max(0.0, volume - wanted);
}
}  // namespace detail

/// Rows of the bonds that the selection keeps and reaches, with their gaps.
inline std::vector<candidate> candidates(const pair_view& view, const bond_selection& selection) {
  std::vector<candidate> found;
  view.for_each_row([&](std::size_t p) {
    const auto [i, j] = view.ids(p);
    const double gap = view.gap(p);
    if (!selection.reaches(gap) || !selection.keeps(i, j)) return;
    found.push_back({p, view.bridge_of(p, gap, 0), {i, j}, view.counts_here(p)});
  });
  return found;
}

/// How far apart two grains can be and still get a bridge in a homogeneous distribution, m: what the list must see
/// first. alpha is largest if only touching pairs receive, and the list has all of these; the largest grains may have no
/// listed pair yet.
template <class Liquid, Host H = alone>
double homogeneous_reach(const bonds<Liquid>& b, const pair_view& view, const std::vector<candidate>& all,
                         double liquid_volume, const H& host = {}) {
  const double alpha = possible_alpha(all, liquid_volume, host).high;
  double farthest = 0;
  const auto [smallest, largest] = extremes_of(view.radius, host);
  for (const double r : {smallest, largest}) farthest = std::max(farthest, b.farthest_of(view, r, alpha * r * r * r));
  return farthest;
}

/// Protocol 1 and the initial state: everything that is here back to the reservoir, then what the grains hold as films,
/// then V_b = alpha R^3 over all eligible pairs. Liquid that makes no bridge of the minimum volume stays on the grains in
/// proportion to R^3.
template <class Liquid, Host H = alone>
void distribute_homogeneously(bonds<Liquid>& b, const pair_view& view, const H& host = {}) {
  const std::vector<candidate> all = candidates(view, b.selection());
  std::vector<double> before(view.rows(), 0.0);
  view.for_each_row([&](std::size_t p) {
    before[p] = b.book().bonds()[p];
    if (before[p] > 0) b.drain(p, ledger::reservoir(), view.gap(p), view);
  });
  for (std::size_t g = 0; g < view.radius.size(); ++g) b.empty_film(g, ledger::reservoir(), view);

  // All that is here is in the reservoir now; this figure has no round-off of the moves.
  const double volume = detail::fill_roughness(b, view, std::max(0.0, b.book().here(host)), host);
  const homogeneous_share share =
      share_homogeneously(b.policies().rupture(), b.policies().substance(), all, volume, host);
  if (share.alpha > 0 && share.alpha >= b.policies().formation().minimum_volume) {
    for (const std::size_t k : share.eligible) {
      const std::size_t p = all[k].pair;
      b.move(ledger::reservoir(), ledger::bond_of(p), share.alpha * all[k].size(), p, all[k].geometry.gap, view);
      b.made(p, view);
    }
  } else {
    detail::spread_over_grains(
        b, view, volume, [](double r) { return r * r * r; }, host);
  }
  view.for_each_row([&](std::size_t p) {
    const double now = b.book().bonds()[p];
    if (now == 0) b.refresh(p, view);  // its films have changed, and with them whether it may form
    if (before[p] > 0 && now == 0) b.note(bridge_change::broke, p, view.gap(p), before[p], view);
    if (before[p] == 0 && now > 0) b.note(bridge_change::formed, p, view.gap(p), now, view);
  });
}

}  // namespace pendular
