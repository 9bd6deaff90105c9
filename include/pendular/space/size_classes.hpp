// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/strided.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pendular {

/// What looking for partners costs, in tests of one pair of grains.
namespace search_cost {
inline constexpr double line = 6;  // to find the grains in a row of cells
}

/// Grains by size, the largest first. What counts is the halo of a grain, its radius and half of the range of the list:
/// two grains can be a pair if their halos meet. The largest halo begins a class and the next class those below half of
/// it, so that a much larger grain does not cut a narrow grading of small ones in two. Two such classes become one where
/// that makes the search cheaper; what a class holds is then within a factor of 4.
class size_classes {
 public:
  struct size_class {
    double halo, least_halo;  // m, largest and smallest
    std::size_t count;
    std::vector<std::size_t> rows;  // in their order
    bool are_copies = false;
  };

  /// Rows from `kept` on are copies of grains of other parts of a scene, and a class of their own behind all others.
  size_classes(strided<const double> radii, double range, std::size_t kept) : half_range_(0.5 * range), kept_(kept) {
    const strided<const double> own = radii.first(kept);
    find_classes(own);
    merge_classes();
    for (size_class& c : classes_) c.rows.reserve(c.count);
    for (std::size_t row = 0; row < kept; ++row) classes_[class_of(halo(radii[row]))].rows.push_back(row);
    if (kept < radii.size()) add_copies(radii);
  }
  size_classes(strided<const double> radii, double range) : size_classes(radii, range, radii.size()) {}
  std::size_t kept() const { return kept_; }

  double halo(double radius) const { return radius + half_range_; }
  const std::vector<size_class>& all() const { return classes_; }

 private:
  static constexpr double spread = 2, widest_spread = 4;

  void find_classes(strided<const double> radii) {
    const auto largest_below = [&](double bound) {
      double largest = 0;
      for (const double r : radii) {
        if (halo(r) < bound) largest = std::max(largest, halo(r));
      }
      return largest;
    };
    double largest = largest_below(std::numeric_limits<double>::infinity());
    while (largest > 0) {
      size_class c{largest, largest, 0, {}};
      for (const double r : radii) {
        if (halo(r) > largest || halo(r) < largest / spread) continue;
        c.least_halo = std::min(c.least_halo, halo(r));
        ++c.count;
      }
      classes_.push_back(c);
      largest = c.least_halo > 0 ? largest_below(largest / spread) : 0;
    }
  }

  void add_copies(strided<const double> radii) {
    size_class copies{0, std::numeric_limits<double>::infinity(), radii.size() - kept_, {}, true};
    for (std::size_t row = kept_; row < radii.size(); ++row) {
      copies.halo = std::max(copies.halo, halo(radii[row]));
      copies.least_halo = std::min(copies.least_halo, halo(radii[row]));
      copies.rows.push_back(row);
    }
    classes_.push_back(std::move(copies));
  }

  /// Decided by numbers and extremes of the classes alone, which do not depend on the order of the rows.
  void merge_classes() {
    double space = 0;  // m3, what the grains would take if they filled half of it
    for (const size_class& c : classes_) {
      const double typical = 0.5 * (c.halo + c.least_halo);
      space += 8.4 * static_cast<double>(c.count) * typical * typical * typical;
    }
    std::vector<size_class> merged;
    for (const size_class& c : classes_) {
      if (!merged.empty() && are_cheaper_as_one(merged.back(), c, space)) {
        merged.back().least_halo = c.least_halo;
        merged.back().count += c.count;
      } else {
        merged.push_back(c);
      }
    }
    classes_ = std::move(merged);
  }

  static bool are_cheaper_as_one(const size_class& larger, const size_class& smaller, double space) {
    if (larger.halo > widest_spread * smaller.least_halo) return false;
    const double n_large = static_cast<double>(larger.count), n_small = static_cast<double>(smaller.count),
                 n = n_large + n_small;
    const double in_large_cell = 8 * larger.halo * larger.halo * larger.halo / space;
    const double in_small_cell = 8 * smaller.halo * smaller.halo * smaller.halo / space;
    // Half of 27 cells for the pairs of a class; a ball in cells of the other one meets about 2.75 cells in each direction
    // from the small side, and one more than two for every time that the large grain is larger from the other.
    const double within = 13.5 * (n_large * n_large * in_large_cell + n_small * n_small * in_small_cell);
    const double across = larger.halo / smaller.halo + 2;
    const double from_small = n_small * (search_cost::line * 7.5 + 21 * n_large * in_large_cell);
    const double from_large = n_large * across * across * (search_cost::line + across * n_small * in_small_cell);
    return 13.5 * n * n * in_large_cell <= within + std::min(from_small, from_large);
  }

  std::size_t class_of(double halo) const {
    std::size_t k = 0;
    while (k + 1 < classes_.size() && halo < classes_[k].least_halo) ++k;
    return k;
  }

  double half_range_;
  std::size_t kept_;
  std::vector<size_class> classes_;
};

}  // namespace pendular
