// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/strided.hpp>
#include <pendular/space/graded_grid.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular {

/// Verlet list: every pair of grains whose gap was below range when the list was made. `first` is the grain of lower
/// id, so that a pair looks the same in every list; both arrays are padded to whole blocks by repeating the last pair.
class pair_list {
 public:
  /// A pair as its grain sees it.
  struct incidence {
    std::uint32_t pair : 31;
    std::uint32_t is_second : 1;
  };

  std::size_t size() const { return size_; }
  std::size_t padded_size() const { return first_.size(); }
  double range() const { return range_; }
  std::span<const std::int32_t> first() const { return first_; }
  std::span<const std::int32_t> second() const { return second_; }

  /// Rows of grains that it was made for.
  std::size_t grains() const { return ids_.size(); }

  /// Pairs of a grain, sorted by the partner's id: sums over them do not depend on the storage order.
  std::span<const incidence> pairs_of(std::size_t row) const { return by_grain().of(row); }

  /// The pair of a grain with a partner; one beyond all if they are not listed.
  std::size_t pair_with(std::size_t row, std::int64_t id) const {
    const auto pairs = pairs_of(row);
    const auto before = [&](const incidence& i, std::int64_t wanted) { return partner(i) < wanted; };
    const auto found = std::lower_bound(pairs.begin(), pairs.end(), id, before);
    return found == pairs.end() || partner(*found) != id ? size() : static_cast<std::size_t>(found->pair);
  }

  /// The same for loops over many grains, to be kept in a local variable.
  class view {
   public:
    view(const std::size_t* start, const incidence* all) : start_(start), all_(all) {}
    std::span<const incidence> of(std::size_t row) const { return {all_ + start_[row], all_ + start_[row + 1]}; }

   private:
    const std::size_t* start_;
    const incidence* all_;
  };
  view by_grain() const { return {start_.data(), incidences_.data()}; }

  /// Makes the list for grains already stored in the order of the grid. `came_from[row]` is the row a grain had in
  /// the list before; the answer tells for every pair which pair of the old list it was, or -1. Within a chunk of grains
  /// touching pairs come first, then those with a gap below `reach`, then the rest: so most blocks are of one kind.
  std::vector<std::int32_t> rebuild(strided<const vector> positions, strided<const double> radii,
                                    std::span<const std::int64_t> ids, const graded_grid& grid, double range,
                                    double reach, std::span<const std::size_t> came_from) {
    const pair_list before = std::move(*this);
    range_ = range;
    ids_.assign(ids.begin(), ids.end());
    find_pairs(positions, radii, grid, reach);
    list_incidences();
    std::vector<std::int32_t> origin(size_, -1);
    for_chunks(ids_.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t row = begin; row < end; ++row) find_origins(row, before, came_from[row], origin);
    });
    return origin;
  }

 private:
  static constexpr std::size_t chunk = 256;

  std::int64_t partner(const incidence& i) const {
    return ids_[static_cast<std::size_t>((i.is_second ? first_ : second_)[i.pair])];
  }

  /// For the pairs whose first grain is that of the row. Old and new ones are both sorted by the partner, so that each is
  /// looked at once, however many a grain has.
  void find_origins(std::size_t row, const pair_list& before, std::size_t old_row,
                    std::vector<std::int32_t>& origin) const {
    if (old_row + 1 >= before.start_.size()) return;
    const auto old = before.pairs_of(old_row);
    auto at = old.begin();
    for (const incidence& n : pairs_of(row)) {
      if (n.is_second) continue;
      const std::int64_t id = partner(n);
      while (at != old.end() && (at->is_second || before.partner(*at) < id)) ++at;
      if (at == old.end()) return;
      if (before.partner(*at) == id) origin[n.pair] = static_cast<std::int32_t>(at->pair);
    }
  }

  void find_pairs(strided<const vector> positions, strided<const double> radii, const graded_grid& grid, double reach) {
    std::vector<std::array<std::vector<std::int32_t>, 3>> found(chunk_count(positions.size(), chunk));
    for_chunks(positions.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      for (std::size_t a = begin; a < end; ++a) {
        grid.for_candidates(a, positions[a], radii[a], [&](std::size_t from, std::size_t to) {
          for (std::size_t b = from; b < to; ++b) {
            const vector d = positions[b] - positions[a];
            const double touch = radii[a] + radii[b], square = dot(d, d);
            const auto farther = [&](double gap) { return square > (touch + gap) * (touch + gap); };
            if (farther(range_)) continue;
            const bool in_order = ids_[a] < ids_[b];
            auto& kind = found[c][farther(reach) ? 2 : farther(0) ? 1 : 0];
            kind.push_back(static_cast<std::int32_t>(in_order ? a : b));
            kind.push_back(static_cast<std::int32_t>(in_order ? b : a));
          }
        });
      }
    });
    gather(found);
  }

  void gather(const std::vector<std::array<std::vector<std::int32_t>, 3>>& found) {
    first_.clear();
    second_.clear();
    for (const auto& kinds : found) {
      for (const auto& part : kinds) {
        for (std::size_t k = 0; k < part.size(); k += 2) {
          first_.push_back(part[k]);
          second_.push_back(part[k + 1]);
        }
      }
    }
    size_ = first_.size();
    if (size_ > 0) {
      first_.resize(padded(size_), first_.back());
      second_.resize(padded(size_), second_.back());
    }
  }

  void list_incidences() {
    start_.assign(ids_.size() + 1, 0);
    for (std::size_t p = 0; p < size_; ++p) {
      ++start_[static_cast<std::size_t>(first_[p]) + 1];
      ++start_[static_cast<std::size_t>(second_[p]) + 1];
    }
    for (std::size_t row = 0; row < ids_.size(); ++row) start_[row + 1] += start_[row];
    incidences_.resize(2 * size_);
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t p = 0; p < size_; ++p) {
      incidences_[next[static_cast<std::size_t>(first_[p])]++] = {static_cast<std::uint32_t>(p) & 0x7fffffffu, 0};
      incidences_[next[static_cast<std::size_t>(second_[p])]++] = {static_cast<std::uint32_t>(p) & 0x7fffffffu, 1};
    }
    for_chunks(ids_.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t row = begin; row < end; ++row) sort_by_partner(row);
    });
  }

  void sort_by_partner(std::size_t row) {
    const auto from = incidences_.begin() + static_cast<std::ptrdiff_t>(start_[row]);
    const auto to = incidences_.begin() + static_cast<std::ptrdiff_t>(start_[row + 1]);
    std::sort(from, to, [&](const incidence& a, const incidence& b) { return partner(a) < partner(b); });
  }

  std::size_t size_ = 0;
  double range_ = 0;
  std::vector<std::int32_t> first_, second_;
  std::vector<std::int64_t> ids_;  // of the rows, by which the next list finds what its pairs were
  std::vector<std::size_t> start_;
  std::vector<incidence> incidences_;
};

}  // namespace pendular
