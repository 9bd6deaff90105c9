// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/host.hpp>

#include <algorithm>
#include <limits>

namespace pendular {

/// Smallest and largest of some numbers over all parts of a scene; {inf, -inf} of none.
struct extremes {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
};

template <class Range, Host H>
extremes extremes_of(const Range& numbers, const H& host) {
  extremes e;
  for (const double v : numbers) e = {std::min(e.smallest, v), std::max(e.largest, v)};
  return {-host.most(-e.smallest), host.most(e.largest)};
}

}  // namespace pendular
