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

/// Errors: input_error for a grading without classes, a diameter that is none, a negative proportion, or proportions
/// whose sum is not 1.
inline void validate(const grading& g) {
  constexpr auto page = "docs/reference/scenes.md";
  expects(!g.empty(), "the number of classes of a grading", 0, "at least 1", page);
  double sum = 0;
  for (const grain_class& c : g) {
    expects_positive("a diameter of a grading (m)", c.diameter, page);
    expects(c.proportion >= 0, "a proportion of a grading", c.proportion, "at least 0", page);
    sum += c.proportion;
  }
  expects(std::abs(sum - 1) < 1e-9, "the sum of the proportions of a grading", sum, "1", page);
}

/// Rows of grains are counted by 31 bits.
inline void expects_countable(std::int64_t grains) {
  constexpr std::int64_t most = (std::int64_t{1} << 31) - 1;
  expects(grains > 0 && grains <= most, "the number of grains", static_cast<double>(grains), "1 to 2^31 - 1",
          "docs/reference/scenes.md");
}

/// Diameters of `count` grains in random order: exact proportions, rounded so that the numbers add up.
/// Errors: input_error.
inline std::vector<double> diameters(const grading& g, std::int64_t count, std::uint64_t seed) {
  validate(g);
  expects_countable(count);
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
