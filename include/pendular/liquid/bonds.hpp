// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/extremes.hpp>
#include <pendular/core/host.hpp>
#include <pendular/core/scalar_table.hpp>
#include <pendular/law/validity.hpp>
#include <pendular/liquid/bond_size.hpp>
#include <pendular/liquid/bridge_event.hpp>
#include <pendular/liquid/ledger.hpp>
#include <pendular/liquid/liquid.hpp>
#include <pendular/liquid/pair_view.hpp>
#include <pendular/liquid/selection.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular {

/// The bridges of a scene: the ledger, and per pair what a step needs of it (the coefficients of the capillary law, the
/// gap at which the bridge breaks, the gap below which one would form). The only owner of liquid: nobody else writes to the
/// ledger, so that pull and thresholds always are those of the volume. Rows are those of the pair_view: the pairs of the
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
  /// To be written to only as long as there is no bridge that was made of them.
  Liquid& policies() { return liquid_; }
  const ledger& book() const { return ledger_; }
  bool is_bonded(std::size_t p) const { return ledger_.bonds()[p] > 0; }
  std::size_t count() const {
    return static_cast<std::size_t>(
        std::count_if(ledger_.bonds().begin(), ledger_.bonds().end(), [](double v) { return v > 0; }));
  }

  /// As ledger has them.
  void introduce(double volume, bool into_this = true) { ledger_.introduce(volume, into_this); }
  void resize_films(std::size_t grains) { ledger_.resize_films(grains); }
  void permute_films(std::span<const std::size_t> order) { ledger_.permute_films(order); }
  ledger::account open_outside(std::string_view name) { return ledger_.open_outside(name); }

  /// Bridges that formed and ended, and one by one if they are kept.
  const bond_events& events() const { return events_; }
  void restore_events(const bond_events& counts) { events_ = counts; }
  const std::vector<bridge_event>& log() const { return log_; }
  std::vector<bridge_event> take_log() { return std::exchange(log_, {}); }
  void keep_log(bool kept) {
    keeps_log_ = kept;
    log_.clear();
  }
  void note(bridge_change what, std::size_t p, double gap, double volume, const pair_view& view) {
    if (!view.counts_here(p)) return;
    ++(what == bridge_change::formed ? events_.formations : events_.ruptures);
    if (keeps_log_) log_.push_back({what, view.ids(p), p, gap, volume});
  }

  /// Whether films have changed since the protocol was last asked: it is then asked though no bridge breaks or forms.
  bool asks_protocol() const { return asks_protocol_; }
  void ask_protocol(bool asked = true) { asks_protocol_ = asked; }

  /// Rows whose bridge was made another one since that was last forgotten, in ascending order.
  std::vector<std::size_t> changed_rows() const {
    auto first_changes = changed_;
    const auto by_row = [](const change& a, const change& c) { return a.row < c.row; };
    std::stable_sort(first_changes.begin(), first_changes.end(), by_row);
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < first_changes.size(); ++k) {
      const auto [row, before] = first_changes[k];
      const bool first = k == 0 || first_changes[k - 1].row != row;
      if (first && ledger_.bonds()[row] != before) rows.push_back(row);
    }
    return rows;
  }
  void forget_changed_rows() { changed_.clear(); }
  /// What the bridge of every row had before it was changed, m3; no number where it was not.
  std::vector<double> volumes_before() const {
    std::vector<double> before(breaks_above_.size(), std::numeric_limits<double>::quiet_NaN());
    for (auto c = changed_.rbegin(); c != changed_.rend(); ++c) before[c->row] = c->before;
    return before;
  }
  void restore_change(std::size_t row, double before) { changed_.push_back({row, before}); }

  /// For a part that takes its grains and their bridges anew: as if there were none.
  void forget_rows(std::size_t grains) {
    ledger_.forget_rows(grains);
    changed_.clear();
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
  double work() const { return work_.value(); }
  const reproducible_sum& work_sum() const { return work_; }

  /// Puts back what a checkpoint had.
  void restore(std::size_t p, double volume, const pair_view& view) {
    ledger_.restore(ledger::bond_of(p), volume);
    refresh(p, view);
  }
  void restore_film(std::size_t grain, double volume) { ledger_.restore(ledger::film_of(grain), volume); }
  void restore_books(const ledger::books& books) { ledger_.restore(books); }
  void restore_work(const reproducible_sum& work) { work_ = work; }

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
  template <Host H = alone>
  double reach(const pair_view& view, const H& host = {}) const {
    double farthest = 0;
    for (const double gap : breaks_above_) farthest = std::max(farthest, gap);
    return std::max(host.most(farthest), formation_reach(view, host));
  }

  /// The part of it that films and bridges of today could form, m.
  template <Host H = alone>
  double formation_reach(const pair_view& view, const H& host = {}) const {
    if (!Liquid::redistributes_locally) return 0;
    if (liquid_.formation().reach(1.0) == liquid_.formation().reach(2.0)) return liquid_.formation().reach(1.0);
    std::vector<double> liquid(ledger_.films().begin(), ledger_.films().end());
    view.for_each_row([&](std::size_t p) {
      view.for_each_grain_of(p, [&](std::size_t grain) { liquid[grain] += ledger_.bonds()[p]; });
    });
    // Of copies not all bridges are here; what they have in all is more and known to their keepers.
    const double most = 2 * std::max(extremes_of(liquid, host).largest, 0.0);
    const auto [smallest, largest] = extremes_of(view.radius, host);
    if (!(largest > 0)) return 0;
    return liquid_.formation().reach(std::max(farthest_of(view, smallest, most), farthest_of(view, largest, most)));
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
    carry_changed(origin);
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
    changed_.push_back({p, ledger_.bonds()[p]});
    const bool counts = view.counts_here(p);
    ledger_.transfer(counted(from, counts), counted(to, counts), volume);
    refresh(p, view);
    if (counts) work_.add(energy(p, gap, view) - before);
  }

  /// Moves liquid between a film and an account that is no bond. The thresholds of the pairs of the film are then to be
  /// refreshed.
  void fill_film(ledger::account from, std::size_t grain, double volume, const pair_view& view) {
    ledger_.transfer(counted(from, view.keeps(grain)), ledger::film_of(grain), volume);
  }
  void drain_film(std::size_t grain, ledger::account to, double volume, const pair_view& view) {
    ledger_.transfer(ledger::film_of(grain), counted(to, view.keeps(grain)), volume);
  }
  void empty_film(std::size_t grain, ledger::account to, const pair_view& view) {
    ledger_.empty(ledger::film_of(grain), counted(to, view.keeps(grain)));
  }
  /// Films of copies become those that their keepers have. Answers which did change.
  template <Host H>
  std::vector<std::size_t> mirror_films(const pair_view& view, const H& host) {
    if constexpr (is_distributed<H>) {
      return ledger_.mirror_films(view.kept, host);
    } else {
      return {};
    }
  }

  /// All of bond p, to another account.
  void drain(std::size_t p, ledger::account to, double gap, const pair_view& view) {
    move(ledger::bond_of(p), to, ledger_.bonds()[p], p, gap, view);
  }

  /// Other parameters of the same policies, from here on: what bridges store under them is work done on the liquid.
  void change_policies(const Liquid& next, const pair_view& view) {
    std::vector<double> before(view.rows(), 0.0);
    view.for_each_row([&](std::size_t p) { before[p] = energy(p, view.gap(p), view); });
    liquid_ = next;
    idle_ = prepare(liquid_.law(), bridge<double>{0, 1e-3, 1, 1}, liquid_.substance());
    for (std::size_t p = 0; p < view.rows(); ++p) refresh(p, view);
    view.for_each_row([&](std::size_t p) {
      if (!is_bonded(p)) return;
      if (view.counts_here(p)) work_.add(energy(p, view.gap(p), view) - before[p]);
      changed_.push_back({p, -1});  // its pull is another one, though its volume is not
      made(p, view);
    });
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
    if (!view.counts_here(p)) return;
    const bridge<double> b = view.bridge_of(p, 0, ledger_.bonds()[p]);
    const auto leaves = [&](const validity& v) { return v.covers(b, liquid_.substance()) ? 0 : 1; };
    outside_.capillary_law += leaves(validity_of<typename Liquid::capillary_law>());
    outside_.rupture_law += leaves(validity_of<typename Liquid::rupture_law>());
  }

 private:
  /// Accounts of the whole scene keep what belongs to rows that are counted here.
  static ledger::account counted(ledger::account a, bool counts) {
    const bool of_row = a.what == ledger::kind::film || a.what == ledger::kind::bond;
    return counts || of_row ? a : ledger::elsewhere();
  }

  void carry_changed(std::span<const std::int32_t> origin) {
    if (changed_.empty()) return;
    std::vector<std::size_t> row_now(breaks_above_.size(), origin.size());
    for (std::size_t p = 0; p < origin.size(); ++p) {
      if (origin[p] >= 0) row_now[static_cast<std::size_t>(origin[p])] = p;
    }
    std::vector<change> now;
    for (const auto& [row, before] : changed_) {
      if (row_now[row] < origin.size()) now.push_back({row_now[row], before});
    }
    changed_.swap(now);
  }

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
  reproducible_sum work_;
  out_of_validity outside_;
  bond_events events_;
  std::vector<bridge_event> log_;
  bool keeps_log_ = false, asks_protocol_ = false;
  struct change {
    std::size_t row;
    double before;  // volume, m3
  };
  std::vector<change> changed_;
};

/// In place of bonds in a dry scene.
struct no_bonds {
  static constexpr bool knows_planes = false;
  static constexpr bool forms_on_closing = false;
  static constexpr bool is_viscous = false;
  no_bonds() = default;
  explicit no_bonds(const none&) {}
};

}  // namespace pendular
