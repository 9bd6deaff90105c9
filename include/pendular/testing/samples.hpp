// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace pendular::testing {

/// Pairs of a grain of this radius and one up to a hundred times larger, or a wall.
inline std::vector<approach<double>> approach_samples(double radius = 5e-4) {
  std::vector<approach<double>> samples;
  for (const double ratio : {1.0, 2.0, 100.0, std::numeric_limits<double>::infinity()}) {
    for (const double gap : {-2e-2, -1e-3, -1e-6, 0.0, 1e-6, 1e-1}) {
      for (const double speed : {-1.0, -1e-3, 0.0, 1e-4, 2.0}) {
        samples.push_back({gap * radius, speed, 1.2e-6, radius, ratio * radius});
      }
    }
  }
  return samples;
}

/// Bridges from a millionth to a tenth of the smaller grain's radius cubed, from overlap to beyond rupture; walls only
/// for laws that know planes.
inline std::vector<bridge<double>> bridge_samples(const validity& law = {}, double radius = 5e-4) {
  std::vector<bridge<double>> samples;
  std::vector<double> ratios{1, 2, 10, 100};
  if (law.planes) ratios.push_back(wall_radius(1.0));
  for (const double ratio : ratios) {
    for (const double volume : {1e-6, 1e-4, 1e-2, 1e-1}) {
      for (const double gap : {-1e-2, -1e-6, 0.0, 1e-3, 1e-1, 0.5, 1.0, 1.5}) {
        const double length = gap < 0 ? radius : radius * std::cbrt(volume);
        samples.push_back({gap * length, volume * radius * radius * radius, radius, ratio * radius});
      }
    }
  }
  return samples;
}

/// Slips in the plane across (0.48, 0.6, 0.64), from none to far beyond any sliding threshold.
inline std::vector<slip<double>> slip_samples(double time_step = 1e-6) {
  std::vector<slip<double>> samples;
  const Vec3<double> normal{0.48, 0.6, 0.64};
  const Vec3<double> across{0.8, -0.64, 0.0};
  const double length = norm(across);
  const Vec3<double> first = (1 / length) * across;
  const Vec3<double> second = cross(normal, first);
  for (const double speed : {0.0, 1e-12, 1e-6, 1e-3, 1e-1, 10.0, 1e6}) {
    for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
      const Vec3<double> direction = std::cos(angle) * first + std::sin(angle) * second;
      samples.push_back({speed * direction, normal, 3e-7, 4.0, time_step});
    }
  }
  return samples;
}

}  // namespace pendular::testing
