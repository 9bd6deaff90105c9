// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace pendular::scene {

/// Proportion by number of grains of a diameter.
struct grain_class {
  double diameter;    // m
  double proportion;  // the sum over all classes is 1
};
using grading = std::vector<grain_class>;

/// Diameters of the simple-compression sample (Richefeu et al. 2007, Table II).
inline grading compression_grading() {
  return {{0.8e-3, 0.1}, {0.9e-3, 0.2}, {1.0e-3, 0.2}, {1.1e-3, 0.2}, {1.2e-3, 0.2}, {1.3e-3, 0.1}};
}

/// Diameters of the direct-shear sample (Richefeu et al. 2007, section 3.2).
inline grading shear_grading() { return {{2.0e-3, 0.5}, {1.5e-3, 0.3}, {1.0e-3, 0.2}}; }

/// Mean diameter by number, m.
inline double mean_diameter(const grading& g) {
  return std::accumulate(g.begin(), g.end(), 0.0,
                         [](double sum, const grain_class& c) { return sum + c.diameter * c.proportion; });
}

/// Diameters of `count` grains in random order: exact proportions, rounded so that the numbers add up.
inline std::vector<double> diameters(const grading& g, std::int64_t count, std::uint64_t seed) {
  expects(count > 0, "the number of grains", static_cast<double>(count), "at least 1", "docs/reference/scenes.md");
  const double sum =
      std::accumulate(g.begin(), g.end(), 0.0, [](double s, const grain_class& c) { return s + c.proportion; });
  expects(std::abs(sum - 1) < 1e-9, "the sum of the proportions of a grading", sum, "1", "docs/reference/scenes.md");
  std::vector<double> all;
  double wanted = 0;
  for (const grain_class& c : g) {
    wanted += c.proportion * static_cast<double>(count);
    while (static_cast<double>(all.size()) < std::round(wanted)) all.push_back(c.diameter);
  }
  // Not std::shuffle: its result differs between standard libraries.
  boost::random::mt19937_64 random(seed);
  for (std::size_t k = all.size(); k > 1; --k) {
    std::swap(all[k - 1], all[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(random)]);
  }
  return all;
}

}  // namespace pendular::scene
