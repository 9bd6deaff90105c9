// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pendular {

/// Four sums at once in about twice the precision, which know whether they are, rounded, the exact ones: then what
/// reproducible_sum has at several times the cost.
/// Source of the error of an addition: D. E. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
class certain_sum {
 public:
  void add(const detail::four& v) {
    const detail::four next = sum_ + v, part = next - sum_;
    const detail::four lost = (sum_ - (next - part)) + (v - part);
    sum_ = next;
    lost_ += lost;
    doubt_ += abs(lost);
    ++count_;
  }

  /// One of the four; no number if it is too near to the middle of two numbers.
  double value(int k) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const double sum = sum_[k], lost = lost_[k];
    if (doubt_[k] == 0) return sum;             // nothing was lost
    if (!(doubt_[k] > 1e-250)) return unknown;  // what follows would be subnormal
    const double rounded = sum + lost, part = rounded - sum;
    const double rest = (sum - (rounded - part)) + (lost - part);
    // Adding up n losses loses n u times the sum of their sizes at most; twice that.
    const double error = static_cast<double>(count_) * std::numeric_limits<double>::epsilon() * doubt_[k];
    const double up = std::nextafter(rounded, HUGE_VAL) - rounded, down = rounded - std::nextafter(rounded, -HUGE_VAL);
    if (std::abs(rest) + error < 0.499 * std::min(up, down)) return rounded;
    return unknown;
  }

 private:
  detail::four sum_{0.0}, lost_{0.0}, doubt_{0.0};
  std::size_t count_ = 0;
};

}  // namespace pendular
