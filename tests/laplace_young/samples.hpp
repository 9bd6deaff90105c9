// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/solve.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

// Bridges from all of the solver's range, in SI: water between a grain of 1 mm and another body.
namespace samples {

using namespace pendular::laplace_young;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double radius = 1e-3, tension = 0.072;

inline liquid_bridge bridge(double ratio, double angle, double volume) {
  return {radius, ratio * radius, angle, volume * radius * radius * radius, tension};
}

inline liquid_bridge swapped(const liquid_bridge& b) {
  return {b.radius_j, b.radius_i, b.contact_angle, b.volume, b.surface_tension};
}

/// Equal spheres, nearly equal ones, a plane, and all ratios between; perfect wetting to 86 degrees; 1e-8 to 1 R^3.
inline std::vector<liquid_bridge> of_all_kinds(int count, unsigned seed) {
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  std::vector<liquid_bridge> all;
  for (int k = 0; k < count; ++k) {
    const double angle = unit(random) < 0.2 ? 0 : 1.5 * unit(random), kind = unit(random);
    const double ratio = kind < 0.1   ? 1
                         : kind < 0.2 ? infinite
                         : kind < 0.4 ? 1 + std::pow(10, -6 * unit(random))
                                      : std::pow(100, unit(random));
    all.push_back(bridge(ratio, angle, std::pow(10, -8 * unit(random))));
  }
  return all;
}

/// Parts of the rupture distance, up to as near as the accuracy is stated.
constexpr double parts[] = {0, 0.1, 0.3, 0.7, 0.95, 0.999, 1 - 1e-6};

/// Volume of a cap of the body between its top and its contact line, m3.
inline double cap_volume(double r, double filling_angle) {
  if (std::isinf(r)) return 0;
  const double h = 2 * r * std::pow(std::sin(filling_angle / 2), 2);
  return std::numbers::pi * h * h * (3 * r - h) / 3;
}

}  // namespace samples
