// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/law/inputs.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace pendular::source {

/// Surface of the meniscus of a bridge, m2. The liquid fills the space between two paraboloids up to a radius a where they
/// are H apart: V_b = pi R (H^2 - D^2) / 2 and a^2 = R (H - D), with 1/R the mean of the curvatures. There the meniscus is
/// an arc over the chord H that meets both under the contact angle, H (pi/2 - theta) / cos(theta) long.
/// Valid for small bridges, V_b << R^3; a gap below 0 counts as 0.
/// Source: O. Pitois, P. Moucheront, X. Chateau 2000, J. Colloid Interface Sci. 231, 26, for the volume.
inline double meniscus_surface(const bridge<double>& b, const fluid& f) {
  const double radius = 2 / (1 / b.radius_i + 1 / b.radius_j), gap = std::max(b.gap, 0.0);
  const double height = std::sqrt(gap * gap + 2 * b.volume / (std::numbers::pi * radius));
  const double arc = height * (std::numbers::pi / 2 - f.contact_angle) / std::cos(f.contact_angle);
  return 2 * std::numbers::pi * std::sqrt(radius * (height - gap)) * arc;
}

/// Liquid evaporates from the films of grains (surface 4 pi R^2) and from the menisci of bridges at constant rates, volume
/// per surface and time, once per period; what leaves is vapour. A bridge that would be left with less than the minimum
/// volume of the formation rule breaks.
struct evaporation {
  static constexpr std::string_view account = "vapour";
  double film_rate;            // m/s
  double bridge_rate;          // m/s
  std::int64_t period = 1000;  // steps

  template <class Door>
  void act(Door& door) const {
    if (bridge_rate > 0) {
      door.for_each_bridge([&](std::size_t pair) {
        const bridge<double> b = door.bridge_at(pair);
        door.drain_bridge(pair,
                          std::min(b.volume, bridge_rate * meniscus_surface(b, door.substance()) * door.time_span()));
      });
    }
    if (film_rate > 0) {
      door.for_each_grain([&](std::size_t grain) {
        const double surface = 4 * std::numbers::pi * door.radius(grain) * door.radius(grain);
        door.dry_grain(grain, std::min(door.film(grain), film_rate * surface * door.time_span()));
      });
    }
  }
};

inline void validate(const evaporation& e) {
  constexpr auto page = "docs/reference/liquid.md";
  expects(e.film_rate >= 0 && std::isfinite(e.film_rate), "the evaporation rate of films (m/s)", e.film_rate,
          "at least 0 and finite", page);
  expects(e.bridge_rate >= 0 && std::isfinite(e.bridge_rate), "the evaporation rate of bridges (m/s)", e.bridge_rate,
          "at least 0 and finite", page);
  expects(e.period > 0, "the period of evaporation (steps)", static_cast<double>(e.period), "at least 1", page);
}

}  // namespace pendular::source
