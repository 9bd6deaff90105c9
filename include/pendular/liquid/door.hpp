// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/by_id.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/host.hpp>
#include <pendular/liquid/redistribution.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular {

/// The one way in which protocols of one's own, sources, sinks and users move liquid: whatever is moved, pull, rupture and
/// formation of the bridges and pairs it touches follow. Grains are named by their row, bridges by that of their pair.
/// Volumes are m3, at least 0 and at most what is there: input_error else, and nothing was moved.
///
/// Where the scene is one of several parts, every part is asked. It visits the grains that it keeps, and all pairs of these,
/// some of which others visit too: what is done to a pair must follow from what the door shows of it, and from sums over the
/// scene, so that all parts do the same.
template <class Liquid, class PairsOf, Host H = alone>
class liquid_door {
 public:
  liquid_door(bonds<Liquid>& b, const pair_view& view, const PairsOf& pairs_of, const H& host = {})
      : bonds_(b), view_(view), pairs_of_(pairs_of), host_(host) {}

  // What is there.
  /// Rows of grains, of copies too.
  std::size_t grains() const { return view_.radius.size(); }
  std::int64_t id(std::size_t grain) const { return view_.id[grain]; }
  const vector& position(std::size_t grain) const { return view_.position[grain]; }  // m
  double radius(std::size_t grain) const { return view_.radius[grain]; }             // m
  double film(std::size_t grain) const { return bonds_.book().films()[grain]; }      // m3
  const Liquid& policies() const { return bonds_.policies(); }
  const fluid& substance() const { return policies().substance(); }

  /// A pair of grains near each other, or a grain near a wettable wall, with or without a bridge.
  bool is_bridged(std::size_t pair) const { return bonds_.is_bonded(pair); }
  bool is_at_wall(std::size_t pair) const { return view_.is_at_wall(pair); }
  std::pair<std::int64_t, std::int64_t> ids(std::size_t pair) const { return view_.ids(pair); }
  std::size_t first_grain(std::size_t pair) const { return view_.grain_i(pair); }
  /// Only of a pair of two grains.
  std::size_t second_grain(std::size_t pair) const { return view_.grain_j(pair); }
  /// Its gap, volume (0 without a bridge) and radii.
  bridge<double> bridge_at(std::size_t pair) const {
    return view_.bridge_of(pair, view_.gap(pair), bonds_.book().bonds()[pair]);
  }
  /// visit(pair) in the order of ids, which is the same whatever the storage. Bridges may come and go meanwhile.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const std::size_t p : rows([](std::size_t) { return true; })) visit(p);
  }
  template <class Visit>
  void for_each_bridge(const Visit& visit) const {
    for (const std::size_t p : rows([&](std::size_t row) { return is_bridged(row); })) visit(p);
  }
  /// The sum over all grains of the scene of a number that each has.
  template <class Number>
  double sum_over_grains(const Number& number) const {
    reproducible_sum sum;
    for (std::size_t grain = 0; grain < view_.kept; ++grain) sum.add(number(grain));
    expect_all_go_on(host_);
    return total(host_, sum);
  }
  /// The same over all pairs or bridges.
  template <class Number>
  double sum_over_bridges(const Number& number) const {
    reproducible_sum sum;
    view_.for_each_row([&](std::size_t p) {
      if (is_bridged(p) && view_.counts_here(p)) sum.add(number(p));
    });
    expect_all_go_on(host_);
    return total(host_, sum);
  }

  /// visit(grain) in the order of ids.
  template <class Visit>
  void for_each_grain(const Visit& visit) const {
    std::vector<std::size_t> all(view_.kept);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    sort_by_id(all, view_.id);
    for (const std::size_t grain : all) visit(grain);
  }

  // Moves within the scene.
  void from_film_to_film(std::size_t from, std::size_t to, double volume) {
    expect_film(from, volume);
    touch(from), touch(to);
    bonds_.drain_film(from, ledger::film_of(to), volume, view_);
  }
  /// Fills a bridge or forms one. False, and nothing is moved, if no bridge of this volume can be there: it is less than
  /// the minimum volume or would break at once.
  bool from_film_to_bridge(std::size_t grain, std::size_t pair, double volume) {
    touch(grain);
    expect_film(grain, volume);
    return fill(ledger::film_of(grain), pair, volume);
  }
  void from_bridge_to_film(std::size_t pair, std::size_t grain, double volume) {
    touch(grain);
    take(pair, ledger::film_of(grain), volume);
  }
  /// Its liquid goes to the films of its grains as that of any broken bridge.
  void break_bridge(std::size_t pair) {
    expect_row("pair", pair, pair < view_.rows() && !view_.is_padding(pair));
    if (!is_bridged(pair)) return;
    view_.for_each_grain_of(pair, [&](std::size_t grain) { touch(grain); });
    detail::break_bond(bonds_, bridge_change::emptied, pair, view_.gap(pair), view_);
  }
  /// All liquid over all eligible pairs (Richefeu et al. 2007, Eqs. 13-14), which the list must see: homogeneous_reach().
  void share_homogeneously() {
    expect_all_go_on(host_);
    distribute_homogeneously(bonds_, view_, host_);
    touched_.clear();  // all thresholds are new
  }
  double homogeneous_reach() const {
    const auto all = candidates(view_, bonds_.selection());
    expect_all_go_on(host_);
    return pendular::homogeneous_reach(bonds_, view_, all, bonds_.book().here(host_), host_);
  }

  /// New thresholds for the pairs of the grains whose films have changed; done by whoever opened the door.
  void close() {
    for (const std::size_t grain : bonds_.mirror_films(view_, host_)) touch(grain);
    detail::refresh_dry_pairs(bonds_, std::move(touched_), view_, pairs_of_);
    touched_.clear();
  }

 protected:
  static constexpr auto page = "docs/reference/liquid.md";

  void touch(std::size_t grain) {
    expect_row("grain", grain, grain < grains());
    touched_.push_back(grain);
  }

  static void expect_row(std::string_view of_what, std::size_t row, bool is_there) {
    if (is_there) return;
    expects(false, "the row of a " + std::string(of_what) + " at a door", static_cast<double>(row),
            "one that the door visits", page);
  }

  static void expect_there(double volume, double there, const std::string& of_what) {
    expects(volume >= 0 && volume <= there, "the volume taken from " + of_what + " (m3)", volume,
            "at least 0 and at most the " + detail::number(there) + " that are there", page);
  }
  void expect_film(std::size_t grain, double volume) const {
    expect_row("grain", grain, grain < grains());
    if (volume >= 0 && volume <= film(grain)) return;
    expect_there(volume, film(grain), "the film of grain " + std::to_string(id(grain)));
  }
  void expect_bridge(std::size_t pair, double volume) const {
    expect_row("pair", pair, pair < view_.rows() && !view_.is_padding(pair));
    const double there = bonds_.book().bonds()[pair];
    if (volume >= 0 && volume <= there) return;
    const auto [i, j] = ids(pair);
    expect_there(volume, there, "the bridge of " + std::to_string(i) + " and " + std::to_string(j));
  }

  bool can_hold(std::size_t pair, double volume, double gap) const {
    if (is_bridged(pair)) return true;
    const double least = policies().formation().minimum_volume * bonds<Liquid>::size_of(pair, view_);
    return volume >= least && gap <= policies().rupture_distance(view_.bridge_of(pair, gap, volume));
  }

  bool fill(ledger::account from, std::size_t pair, double volume) {
    expect_row("pair", pair, pair < view_.rows() && !view_.is_padding(pair));
    const double gap = view_.gap(pair);
    if (volume == 0 || !can_hold(pair, volume, gap)) return false;
    if (!is_bridged(pair)) bonds_.note(bridge_change::formed, pair, gap, volume, view_);
    bonds_.move(from, ledger::bond_of(pair), volume, pair, gap, view_);
    bonds_.made(pair, view_);
    return true;
  }

  /// A bridge that would be left with less than the minimum volume breaks: its rest goes to the films of its grains.
  void take(std::size_t pair, ledger::account to, double volume) {
    expect_bridge(pair, volume);
    if (volume == 0) return;
    const double there = bonds_.book().bonds()[pair];
    const double least = policies().formation().minimum_volume * bonds<Liquid>::size_of(pair, view_);
    if (volume == there) bonds_.note(bridge_change::emptied, pair, view_.gap(pair), there, view_);
    bonds_.move(ledger::bond_of(pair), to, volume, pair, view_.gap(pair), view_);
    if (is_bridged(pair) && bonds_.book().bonds()[pair] < least) break_bridge(pair);
  }

  bonds<Liquid>& bonds_;
  const pair_view& view_;

 private:
  template <class Wanted>
  std::vector<std::size_t> rows(const Wanted& wanted) const {
    std::vector<std::size_t> found;
    view_.for_each_row([&](std::size_t p) {
      if (wanted(p)) found.push_back(p);
    });
    view_.sort_by_ids(found);
    return found;
  }

  const PairsOf& pairs_of_;
  H host_;
  std::vector<std::size_t> touched_;
};

/// The same with moves between the scene and one account outside of it, for sources and sinks.
template <class Liquid, class PairsOf, Host H = alone>
class outside_door : public liquid_door<Liquid, PairsOf, H> {
  using inside = liquid_door<Liquid, PairsOf, H>;

 public:
  outside_door(bonds<Liquid>& b, const pair_view& view, const PairsOf& pairs_of, std::string_view account, double span,
               const H& host = {})
      : inside(b, view, pairs_of, host), outside_(b.open_outside(account)), span_(span) {}

  /// Since the source acted last: its period, s.
  double time_span() const { return span_; }

  void wet_grain(std::size_t grain, double volume) {
    expect_new(volume);
    this->touch(grain);
    this->bonds_.fill_film(outside_, grain, volume, this->view_);
  }
  void dry_grain(std::size_t grain, double volume) {
    this->expect_film(grain, volume);
    this->touch(grain);
    this->bonds_.drain_film(grain, outside_, volume, this->view_);
  }
  /// As from_film_to_bridge.
  bool fill_bridge(std::size_t pair, double volume) {
    expect_new(volume);
    return this->fill(outside_, pair, volume);
  }
  void drain_bridge(std::size_t pair, double volume) { this->take(pair, outside_, volume); }

 private:
  void expect_new(double volume) const {
    expects(volume >= 0 && std::isfinite(volume), "the volume that a source gives (m3)", volume,
            "at least 0 and finite", inside::page);
  }

  ledger::account outside_;
  double span_;
};

}  // namespace pendular
