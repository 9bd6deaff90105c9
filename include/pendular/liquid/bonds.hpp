// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/scalar_table.hpp>
#include <pendular/law/validity.hpp>
#include <pendular/liquid/bond_size.hpp>
#include <pendular/liquid/ledger.hpp>
#include <pendular/liquid/liquid.hpp>
#include <pendular/liquid/pair_view.hpp>
#include <pendular/liquid/selection.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pendular {

/// The bridges of a scene: the ledger, and per pair what a step needs of it (the coefficients of the capillary law, the
/// gap at which the bridge breaks, the gap below which one would form). Rows are those of the pair_view: the pairs of the
/// Verlet list, then the grains near walls that carry bridges.
template <class Liquid>
class bonds {
 public:
  template <class T>
  using coefficients = coefficients_t<typename Liquid::capillary_law, T>;

  static constexpr bool forms_on_closing = Liquid::forms_on_closing;
  static constexpr bool is_viscous = Liquid::is_viscous;
  static constexpr bool knows_planes = validity_of<typename Liquid::capillary_law>().planes &&
                                       validity_of<typename Liquid::rupture_law>().planes &&
                                       (!is_viscous || validity_of<typename Liquid::viscous_law>().planes);
  static constexpr double never = -1e300;  // a gap no pair reaches

  explicit bonds(const Liquid& liquid)
      : liquid_(liquid), idle_(prepare(liquid_.law(), bridge<double>{0, 1e-3, 1, 1}, liquid_.substance())) {}

  const Liquid& policies() const { return liquid_; }
  ledger& book() { return ledger_; }
  const ledger& book() const { return ledger_; }
  bool is_bonded(std::size_t p) const { return ledger_.bonds()[p] > 0; }
  std::size_t count() const {
    return static_cast<std::size_t>(
        std::count_if(ledger_.bonds().begin(), ledger_.bonds().end(), [](double v) { return v > 0; }));
  }

  /// Which pairs distributions wet, and what the grains hold that no protocol makes bridges of.
  const bond_selection& selection() const { return selection_; }
  void select(const bond_selection& selection) { selection_ = selection; }
  /// The film of a grain beyond what it holds, m3; what round-off leaves of a film that was given away is nothing.
  double free_film(std::size_t grain, const pair_view& view) const {
    constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();
    const double held = selection_.held_film(view.radius[grain]), free = ledger_.films()[grain] - held;
    return free > round_off * held ? free : 0.0;
  }

  double breaks_above(std::size_t p) const { return breaks_above_[p]; }
  double forms_below(std::size_t p) const { return forms_below_[p]; }

  /// How often a bridge was made or refilled outside of the validity that its laws state.
  struct out_of_validity {
    std::int64_t capillary_law = 0;
    std::int64_t rupture_law = 0;
  };
  const out_of_validity& outside() const { return outside_; }
  void restore_outside(const out_of_validity& counts) { outside_ = counts; }

  /// Energy set free by forming, breaking and refilling bridges since the start, J; 0 for a law without energy.
  double work() const { return work_; }

  /// Puts back a bridge as a checkpoint had it.
  void restore(std::size_t p, double volume, const pair_view& view) {
    ledger_.restore(ledger::bond_of(p), volume);
    refresh(p, view);
  }
  void restore_work(double work) { work_ = work; }

  /// Pull of a block of pairs, N, zero for pairs without a bridge and beyond rupture.
  block attraction(std::size_t first_pair, const block& gap) const {
    const block ceiling = load(breaks_above_.data() + first_pair);
    // A lane without a bridge is evaluated too, at gap 0 of a bridge of size 1.
    const block asked = min(gap, max(ceiling, block(0.0)));
    const block pull =
        pendular::attraction(liquid_.law(), asked, coefficients_.load_block(first_pair), liquid_.substance());
    return pendular::select(gap < ceiling, pull, block(0.0));
  }

  /// Resistance of a block of bridges, N s/m, zero for pairs without one and beyond rupture.
  bridge_resistance<block> resistance(std::size_t first_pair, const block& gap, const block& radius_i,
                                      const block& radius_j) const requires(Liquid::is_viscous) {
    const auto alive = gap < load(breaks_above_.data() + first_pair);
    const block volume = load(ledger_.bonds().data() + first_pair);
    const auto r = liquid_.viscous().resistance(bridge<block>{gap, volume, radius_i, radius_j}, liquid_.substance());
    return {pendular::select(alive, r.normal, block(0.0)), pendular::select(alive, r.tangential, block(0.0))};
  }

  bool any_bonded(std::size_t first_pair) const { return any(load(breaks_above_.data() + first_pair) > 0); }

  /// Positive where a pair of the block breaks or may form; `before` is the gap one step ago.
  block event(std::size_t first_pair, const block& gap, const block& before) const {
    const block ceiling = load(breaks_above_.data() + first_pair);
    const block floor = load(forms_below_.data() + first_pair);
    const block breaking = pendular::select(ceiling > 0, gap - ceiling, block(0.0));
    block forming = floor - gap;
    if constexpr (forms_on_closing) forming = pendular::select(before < floor, block(0.0), forming);
    return max(breaking, forming);
  }

  bool breaks(std::size_t p, double gap) const { return is_bonded(p) && gap > breaks_above_[p]; }
  bool forms(std::size_t p, double gap, double before) const {
    return !is_bonded(p) && gap < forms_below_[p] && (!forms_on_closing || before >= forms_below_[p]);
  }

  /// Largest rupture distance of a present bridge, or of one that could form from the liquid which the grains have in
  /// films and bridges, m: what the list must see.
  double reach(const pair_view& view) const {
    double farthest = 0;
    for (const double gap : breaks_above_) farthest = std::max(farthest, gap);
    return std::max(farthest, formation_reach(view));
  }

  /// The part of it that films and bridges of today could form, m.
  double formation_reach(const pair_view& view) const {
    if (!Liquid::redistributes_locally || view.radius.empty()) return 0;
    if (liquid_.formation().reach(1.0) == liquid_.formation().reach(2.0)) return liquid_.formation().reach(1.0);
    std::vector<double> liquid(ledger_.films().begin(), ledger_.films().end());
    view.for_each_row([&](std::size_t p) {
      view.for_each_grain_of(p, [&](std::size_t grain) { liquid[grain] += ledger_.bonds()[p]; });
    });
    const double most = 2 * *std::max_element(liquid.begin(), liquid.end());
    const auto [small, large] = std::minmax_element(view.radius.begin(), view.radius.end());
    return liquid_.formation().reach(std::max(farthest_of(view, *small, most), farthest_of(view, *large, most)));
  }

  /// Rupture distance of a bridge of this volume between grains of this radius, or at a wall that carries bridges, m.
  double farthest_of(const pair_view& view, double radius, double volume) const {
    const double between = liquid_.rupture_distance({0, volume, radius, radius});
    if (!view.wet_walls) return between;
    return std::max(between, liquid_.rupture_distance({0, volume, radius, wall_radius(radius)}));
  }

  /// Follows the pairs into a new list. Every bridge must have its pair there: the range of the list sees to it.
  void carry(std::span<const std::int32_t> origin, const pair_view& view) {
    const std::size_t rows = view.rows();
    if (!ledger_.carry_bonds(origin, rows).empty()) {
      throw run_error(
          "a liquid bridge lost its pair when the neighbour list was rebuilt (see docs/reference/liquid.md)");
    }
    coefficients_.carry(origin, rows);
    std::vector<double> breaks_above(rows, never);
    for (std::size_t p = 0; p < origin.size(); ++p) {
      if (origin[p] >= 0) breaks_above[p] = breaks_above_[static_cast<std::size_t>(origin[p])];
    }
    breaks_above_.swap(breaks_above);
    forms_below_.assign(rows, never);
    for (std::size_t p = 0; p < rows; ++p) {
      if (!is_bonded(p)) refresh(p, view);
    }
  }

  /// Moves liquid to or from bond p and keeps coefficients, thresholds and energy book in step.
  void move(ledger::account from, ledger::account to, double volume, std::size_t p, double gap, const pair_view& view) {
    const double before = energy(p, gap, view);
    ledger_.transfer(from, to, volume);
    refresh(p, view);
    work_ += energy(p, gap, view) - before;
  }

  /// All of bond p, to another account.
  void drain(std::size_t p, ledger::account to, double gap, const pair_view& view) {
    move(ledger::bond_of(p), to, ledger_.bonds()[p], p, gap, view);
  }

  /// Coefficients and thresholds of row p from its volume and from the films of its grains.
  void refresh(std::size_t p, const pair_view& view) {
    const bool real = !view.is_padding(p);
    const double volume = real ? ledger_.bonds()[p] : 0.0;
    breaks_above_[p] = forms_below_[p] = never;
    if (volume > 0) {
      const bridge<double> b = view.bridge_of(p, 0, volume);
      breaks_above_[p] = liquid_.rupture_distance(b);
      coefficients_.set_row(p, prepare(liquid_.law(), b, liquid_.substance()));
      return;
    }
    coefficients_.set_row(p, idle_);
    if (Liquid::redistributes_locally && real) forms_below_[p] = formation_gap(p, size_of(p, view), view);
  }

  /// Energy that opening bond p from the gap to rupture would cost, J.
  double energy(std::size_t p, double gap, const pair_view& view) const {
    if constexpr (HasCapillaryEnergy<typename Liquid::capillary_law>) {
      if (!is_bonded(p) || gap >= breaks_above_[p]) return 0;
      return pendular::energy(liquid_.law(), view.bridge_of(p, gap, ledger_.bonds()[p]), coefficients_.row(p),
                              liquid_.substance(), breaks_above_[p]);
    } else {
      return 0;
    }
  }

  /// R^3 of Eq. 14, m3.
  static double size_of(std::size_t p, const pair_view& view) { return bond_size(view.bridge_of(p, 0, 0)); }

  /// To be called when a bridge has got all of its liquid: counts it if its laws do not claim to be valid for it.
  void made(std::size_t p, const pair_view& view) {
    const bridge<double> b = view.bridge_of(p, 0, ledger_.bonds()[p]);
    const auto leaves = [&](const validity& v) { return v.covers(b, liquid_.substance()) ? 0 : 1; };
    outside_.capillary_law += leaves(validity_of<typename Liquid::capillary_law>());
    outside_.rupture_law += leaves(validity_of<typename Liquid::rupture_law>());
  }

 private:
  double formation_gap(std::size_t p, double size, const pair_view& view) const {
    double available = 0;
    view.for_each_grain_of(p, [&](std::size_t grain) { available += free_film(grain, view); });
    if (available < liquid_.formation().minimum_volume * size) return never;
    return liquid_.formation().reach(liquid_.rupture_distance(view.bridge_of(p, 0, available)));
  }

  Liquid liquid_;
  bond_selection selection_;
  ledger ledger_;
  coefficients<double> idle_;  // of a bridge between grains of radius 1, where there is none
  scalar_table<coefficients> coefficients_;
  std::vector<double> breaks_above_, forms_below_;
  double work_ = 0;
  out_of_validity outside_;
};

/// In place of bonds in a dry scene.
struct no_bonds {
  static constexpr bool knows_planes = false;
  static constexpr bool forms_on_closing = false;
  static constexpr bool is_viscous = false;
};

}  // namespace pendular
