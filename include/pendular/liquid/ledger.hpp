// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular {

/// Every bridge and every film of a scene, m3. Liquid enters by `introduce` and moves by `transfer`, never by
/// assignment, so the total changes by round-off only.
class ledger {
 public:
  enum class kind { film, bond, reservoir };

  /// A film has the row of its grain, a bond that of its pair; the reservoir is where liquid waits to be distributed.
  struct account {
    kind what;
    std::size_t row = 0;
  };
  static constexpr account film_of(std::size_t grain) { return {kind::film, grain}; }
  static constexpr account bond_of(std::size_t pair) { return {kind::bond, pair}; }
  static constexpr account reservoir() { return {kind::reservoir}; }

  std::span<const double> films() const { return films_; }
  std::span<const double> bonds() const { return bonds_; }

  double balance(account a) const {
    if (a.what == kind::film) return films_[a.row];
    if (a.what == kind::bond) return bonds_[a.row];
    return reservoir_ + residue_;
  }

  /// New liquid, m3, into the reservoir. Errors: negative or not finite.
  void introduce(double volume) {
    expects(volume >= 0 && std::isfinite(volume), "the liquid volume introduced (m3)", volume, "at least 0 and finite",
            "docs/reference/liquid.md");
    add_to_reservoir(volume);
    introduced_ += volume;
  }

  /// Moves at most what the account has. The reservoir alone may go below 0, by round-off of a full distribution.
  void transfer(account from, account to, double volume) {
    expects(volume >= 0 && std::isfinite(volume), "the liquid volume transferred (m3)", volume, "at least 0 and finite",
            "docs/reference/liquid.md");
    const double moved = from.what == kind::reservoir ? volume : std::min(volume, balance(from));
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

  /// Compensated sum of all accounts, m3.
  double total() const {
    double sum = reservoir_, lost = residue_;
    const auto add_one = [&](double v) {
      const double next = sum + v;
      lost += std::abs(sum) >= std::abs(v) ? (sum - next) + v : (v - next) + sum;
      sum = next;
    };
    for (const double v : films_) add_one(v);
    for (const double v : bonds_) add_one(v);
    return sum + lost;
  }

  void resize_films(std::size_t grains) { films_.resize(grains, 0.0); }

  /// Follows the grains into a new storage order.
  void permute_films(std::span<const std::size_t> order) {
    const std::vector<double> before = films_;
    for (std::size_t row = 0; row < order.size(); ++row) films_[row] = before[order[row]];
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
      add_to_reservoir(bonds_[old]);
    }
    bonds_.swap(moved);
    return orphans;
  }

  /// The whole state, as a checkpoint keeps it.
  struct books {
    double reservoir = 0, residue = 0, introduced = 0;
  };
  books keep() const { return {reservoir_, residue_, introduced_}; }
  void restore(const books& b) {
    reservoir_ = b.reservoir;
    residue_ = b.residue;
    introduced_ = b.introduced;
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
    } else {
      add_to_reservoir(volume);
    }
  }

  void add_to_reservoir(double volume) {
    const double next = reservoir_ + volume;
    residue_ += std::abs(reservoir_) >= std::abs(volume) ? (reservoir_ - next) + volume : (volume - next) + reservoir_;
    reservoir_ = next;
  }

  std::vector<double> films_, bonds_;
  double reservoir_ = 0, residue_ = 0, introduced_ = 0;
};

}  // namespace pendular
