// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/host.hpp>
#include <pendular/core/reproducible_sum.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular {

/// Every bridge and every film of a scene, and what went out of it or came in, m3. Liquid enters by `introduce` and moves
/// by `transfer`, never by assignment: what is here and what is outside add up to what was introduced, to round-off.
class ledger {
 public:
  enum class kind { film, bond, reservoir, outside, elsewhere };

  /// A film has the row of its grain, a bond that of its pair; the reservoir is where liquid waits to be distributed; an
  /// account outside of the scene has the place in which it was opened; elsewhere is what another part of the scene counts.
  struct account {
    kind what;
    std::size_t row = 0;
  };
  static constexpr account film_of(std::size_t grain) { return {kind::film, grain}; }
  static constexpr account bond_of(std::size_t pair) { return {kind::bond, pair}; }
  static constexpr account reservoir() { return {kind::reservoir}; }
  static constexpr account elsewhere() { return {kind::elsewhere}; }

  /// Outside of the scene: vapour, spray, what left with a grain. Positive if the scene has lost liquid to it.
  struct outside_account {
    std::string name;
    reproducible_sum volume = {};  // m3
  };
  std::span<const outside_account> outside() const { return outside_; }
  /// m3; 0 for an account that was never opened.
  double outside(std::string_view name) const {
    for (const outside_account& a : outside_) {
      if (a.name == name) return a.volume.value();
    }
    return 0;
  }
  /// The account of this name, a new one if there is none. Errors: input_error for a name of several lines, because
  /// checkpoints have one per line.
  account open_outside(std::string_view name) {
    for (std::size_t k = 0; k < outside_.size(); ++k) {
      if (outside_[k].name == name) return {kind::outside, k};
    }
    if (name.find('\n') != std::string_view::npos) {
      throw input_error("the name of an account outside of the scene, \"" + std::string(name) +
                        "\", must be on one line (see docs/reference/liquid.md)");
    }
    outside_.push_back({std::string(name)});
    return {kind::outside, outside_.size() - 1};
  }

  std::span<const double> films() const { return films_; }
  std::span<const double> bonds() const { return bonds_; }

  double balance(account a) const {
    if (a.what == kind::film) return films_[a.row];
    if (a.what == kind::bond) return bonds_[a.row];
    if (a.what == kind::outside) return outside_[a.row].volume.value();
    return a.what == kind::reservoir ? reservoir_.value() : 0;
  }

  /// New liquid of the scene, m3, into the reservoir of one part. Errors: negative or not finite.
  void introduce(double volume, bool into_this = true) {
    expects(volume >= 0 && std::isfinite(volume), "the liquid volume introduced (m3)", volume, "at least 0 and finite",
            "docs/reference/liquid.md");
    if (into_this) reservoir_.add(volume);
    introduced_ += volume;
  }

  /// Moves at most what the account has. The reservoir may go below 0, by round-off of a full distribution, and so may
  /// an account outside, from which liquid comes in.
  void transfer(account from, account to, double volume) {
    expects(volume >= 0 && std::isfinite(volume), "the liquid volume transferred (m3)", volume, "at least 0 and finite",
            "docs/reference/liquid.md");
    const bool bounded = from.what == kind::film || from.what == kind::bond;
    const double moved = bounded ? std::min(volume, balance(from)) : volume;
    add(from, -moved);
    add(to, moved);
  }

  /// Everything an account has.
  void empty(account from, account to) {
    const double all = balance(from);
    add(from, -all);
    add(to, all);
  }

  double introduced() const { return introduced_; }

  /// What must be in the scene, m3: introduced less what is outside. No round-off of the moves within it is in it.
  template <Host H = alone>
  double here(const H& host = {}) const {
    reproducible_sum rest;
    for (const outside_account& a : outside_) rest.subtract(a.volume);
    host.sum(std::span(&rest, 1));
    rest.add(introduced_);
    return rest.value();
  }

  /// What is here, counted: all films, bridges and the reservoir, m3.
  double total() const {
    reproducible_sum all = reservoir_;
    for (const double v : films_) all.add(v);
    for (const double v : bonds_) all.add(v);
    return all.value();
  }

  void resize_films(std::size_t grains) { films_.resize(grains, 0.0); }

  /// Follows the grains into a new storage order. Errors: run_error for a grain that is no more and holds liquid.
  void permute_films(std::span<const std::size_t> order) {
    std::vector<double> before = films_;
    films_.resize(order.size());
    for (std::size_t row = 0; row < order.size(); ++row) films_[row] = std::exchange(before[order[row]], 0.0);
    if (std::any_of(before.begin(), before.end(), [](double v) { return v != 0; })) {
      throw run_error("a grain was taken out with liquid on it (see docs/reference/liquid.md)");
    }
  }

  /// Follows the pairs into a new list of `rows` rows: row p was origin[p], or is new where origin[p] < 0. Answers the
  /// old rows that are in no new one although they hold liquid; that liquid is now in the reservoir.
  std::vector<std::size_t> carry_bonds(std::span<const std::int32_t> origin, std::size_t rows) {
    std::vector<double> moved(rows, 0.0);
    for (std::size_t p = 0; p < origin.size(); ++p) {
      if (origin[p] < 0) continue;
      const auto old = static_cast<std::size_t>(origin[p]);
      moved[p] = bonds_[old];
      bonds_[old] = 0;
    }
    std::vector<std::size_t> orphans;
    for (std::size_t old = 0; old < bonds_.size(); ++old) {
      if (bonds_[old] <= 0) continue;
      orphans.push_back(old);
      reservoir_.add(bonds_[old]);
    }
    bonds_.swap(moved);
    return orphans;
  }

  /// What a checkpoint keeps besides films and bonds.
  struct books {
    reproducible_sum reservoir = {};
    double introduced = 0;
    std::vector<outside_account> outside = {};
  };
  books keep() const { return {reservoir_, introduced_, outside_}; }
  void restore(const books& b) {
    reservoir_ = b.reservoir;
    introduced_ = b.introduced;
    outside_ = b.outside;
  }
  /// Films of copies become those that their keepers have; the copies begin at row `kept`. Answers which did change.
  template <Host H>
  std::vector<std::size_t> mirror_films(std::size_t kept, const H& host) {
    const std::vector<double> before(films_.begin() + static_cast<std::ptrdiff_t>(kept), films_.end());
    host.update_copies(films_, 1);
    std::vector<std::size_t> changed;
    for (std::size_t row = kept; row < films_.size(); ++row) {
      if (films_[row] != before[row - kept]) changed.push_back(row);
    }
    return changed;
  }
  /// For a part that takes its grains and their bridges anew: neither films nor bonds.
  void forget_rows(std::size_t grains) {
    films_.assign(grains, 0.0);
    bonds_.clear();
  }

  /// A film or a bond as a checkpoint had it; only for an account that is still empty.
  void restore(account a, double volume) {
    expects(balance(a) == 0, "the volume of an account to be restored (m3)", balance(a), "0",
            "docs/reference/liquid.md");
    add(a, volume);
  }

 private:
  void add(account a, double volume) {
    if (a.what == kind::film) {
      films_[a.row] += volume;
    } else if (a.what == kind::bond) {
      bonds_[a.row] += volume;
    } else if (a.what == kind::outside) {
      outside_[a.row].volume.add(volume);
    } else if (a.what == kind::reservoir) {
      reservoir_.add(volume);
    }
  }

  std::vector<double> films_, bonds_;
  std::vector<outside_account> outside_;
  reproducible_sum reservoir_;
  double introduced_ = 0;
};

}  // namespace pendular
