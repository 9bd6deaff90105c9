// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/space/grains.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pendular::scene {

/// Grains without overlap in a vertical cylinder about the z axis, standing on z = 0: layers of a loose square lattice,
/// shifted at random, so that they mix while they fall.
inline std::vector<grain> loose_column(const std::vector<double>& diameters, double density, double cylinder_radius,
                                       double fall_speed, std::uint64_t seed) {
  const double largest = *std::max_element(diameters.begin(), diameters.end());
  const double spacing = 1.02 * largest, room = cylinder_radius - 0.5 * largest - 0.01 * largest;
  expects(room > spacing, "the radius of the cylinder (m)", cylinder_radius, "at least 2 largest diameters",
          "docs/reference/scenes.md");
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<grain> grains;
  const auto half = static_cast<std::int64_t>(room / spacing) + 1;
  for (double z = 0.55 * largest; grains.size() < diameters.size(); z += spacing) {
    const double shift_x = 0.5 * spacing * unit(random), shift_y = 0.5 * spacing * unit(random);
    for (std::int64_t a = -half; a <= half; ++a) {
      for (std::int64_t b = -half; b <= half; ++b) {
        const double x = static_cast<double>(a) * spacing + shift_x, y = static_cast<double>(b) * spacing + shift_y;
        if (x * x + y * y > room * room || grains.size() == diameters.size()) continue;
        const vector velocity{0.1 * fall_speed * unit(random), 0.1 * fall_speed * unit(random), -fall_speed};
        grains.push_back({{x, y, z}, 0.5 * diameters[grains.size()], density, velocity});
      }
    }
  }
  return grains;
}

}  // namespace pendular::scene
