// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

#include <cmath>
#include <numbers>

namespace pendular {

/// Where a law was fitted or derived, as data: bridges outside of it are counted when they are made.
struct validity {
  double least_volume = 0;                              // V_b / R^3, R the harmonic mean radius
  double largest_volume = 1e300;                        // V_b / R^3
  double largest_ratio = 1e300;                         // of the radii
  double largest_contact_angle = std::numbers::pi / 2;  // rad
  bool geometric_mean = false;                          // R is sqrt(R_i R_j) instead, R_i at a wall
  bool planes = false;                                  // walls too; a scene with wettable walls asks for it

  bool covers(const bridge<double>& b, const fluid& f) const {
    const double ratio = max(b.radius_i, b.radius_j) / min(b.radius_i, b.radius_j);
    const double radius = mean_radius(b), volume = b.volume / (radius * radius * radius);
    return volume >= least_volume && volume <= largest_volume && f.contact_angle <= largest_contact_angle &&
           (is_at_wall(b) ? planes : ratio <= largest_ratio);
  }

 private:
  double mean_radius(const bridge<double>& b) const {
    if (!geometric_mean) return 2 / (1 / b.radius_i + 1 / b.radius_j);
    return is_at_wall(b) ? b.radius_i : std::sqrt(b.radius_i * b.radius_j);
  }
};

/// The validity of a law, a static member `valid`; a law without one claims all.
template <class Law>
constexpr validity validity_of() {
  if constexpr (requires { Law::valid; }) {
    return Law::valid;
  } else {
    return {};
  }
}

}  // namespace pendular
