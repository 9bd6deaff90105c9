// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>
#include <pendular/liquid/pair_view.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace pendular {

/// Gaps of the last evaluation, m, and those of the evaluation before it where bridges that form on closing ask for them.
template <bool KeepsBefore>
class gap_record {
 public:
  std::span<const double> now() const { return now_; }
  gap_history history() const { return {now_, KeepsBefore ? before_ : now_}; }

  /// To be called before every evaluation.
  void turn() {
    if constexpr (KeepsBefore) now_.swap(before_);
  }
  /// To be called before rows are evaluated as they stand: nothing has closed since, but what is new was apart.
  void stand() {
    if constexpr (KeepsBefore) before_ = now_;
  }

  void put(std::size_t first_row, const block& gap) { store(now_.data() + first_row, gap); }
  /// What the gap of this evaluation is to be compared with.
  block before(std::size_t first_row, const block& gap) const {
    if constexpr (KeepsBefore) return load(before_.data() + first_row);
    return gap;
  }

  /// Follows the rows into a new list, as they stand; one that was not listed was apart. Where all gaps are evaluated anew
  /// at once only those of before are kept.
  void carry(std::span<const std::int32_t> origin, std::size_t rows, bool keeps_now) {
    std::vector<double> moved(rows, std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; (KeepsBefore || keeps_now) && p < origin.size(); ++p) {
      if (origin[p] >= 0) moved[p] = now_[static_cast<std::size_t>(origin[p])];
    }
    if constexpr (KeepsBefore) before_ = moved;
    now_.swap(moved);
  }

  /// Takes the gap of the last evaluation from where the grains are, so that a run that is resumed and one that goes on
  /// agree on which contacts are closed.
  void recall(std::size_t row, double gap) { now_[row] = gap; }

 private:
  std::vector<double> now_, before_;
};

}  // namespace pendular
