// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace pendular::observe {

namespace detail {
inline void expect_bins(std::span<const double> edges) {
  constexpr auto page = "docs/reference/observe.md";
  expects(edges.size() >= 2, "the number of edges of bins", static_cast<double>(edges.size()), "at least 2", page);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    expects(std::isfinite(edges[k]), "an edge of a bin", edges[k], "finite", page);
    expects(k == 0 || edges[k] > edges[k - 1], "an edge of a bin", edges[k], "above the edge before it", page);
  }
}
}  // namespace detail

/// Density of values / unit in every bin: the share of all values that lie in it, over its width. A value on an edge
/// counts above it, one on the last edge below. The integral is 1 if the bins hold all values; without values all is 0.
/// Errors: fewer than two edges, edges not finite and increasing, with values a unit not positive and finite.
inline std::vector<double> probability_density(std::span<const double> values, double unit,
                                               std::span<const double> edges) {
  detail::expect_bins(edges);
  std::vector<double> density(edges.size() - 1, 0.0);
  if (values.empty()) return density;
  expects_positive("the unit of a probability density", unit, "docs/reference/observe.md");
  for (const double value : values) {
    const double x = value / unit;
    if (!(x >= edges.front() && x <= edges.back())) continue;
    const auto above = std::upper_bound(edges.begin(), edges.end() - 1, x);
    density[static_cast<std::size_t>(above - edges.begin()) - 1] += 1;
  }
  for (std::size_t k = 0; k < density.size(); ++k) {
    density[k] /= static_cast<double>(values.size()) * (edges[k + 1] - edges[k]);
  }
  return density;
}

}  // namespace pendular::observe
