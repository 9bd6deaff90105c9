// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>

#include <cmath>
#include <numbers>

namespace pendular {

// THE sign convention.
// The unit normal n points from grain i to grain j. The gap is the distance of the surfaces, negative in overlap;
// the closing speed is -d(gap)/dt. Every law returns what its function name says, and the force on grain i is
//     -(repulsion + resistance - attraction) n + traction,
// the force on grain j its opposite. A wall plays grain j with an infinite radius.

/// What a normal or a damping law sees.
template <Scalar T>
struct approach {
  T gap;            // delta_n, m; negative in overlap
  T closing_speed;  // -d(delta_n)/dt, m/s; positive on approach
  T reduced_mass;   // m_i m_j / (m_i + m_j), kg; m_i against a wall
  T radius_i;       // m
  T radius_j;       // m; infinite for a wall
};

/// What a damping law may see of the spring beside it.
template <Scalar T>
struct elastic {
  T push;       // of the normal law, N, at least 0
  T stiffness;  // its tangent, N/m
};

/// What a damping law can prepare once per pair where the stiffness does not depend on the overlap.
template <Scalar T>
struct prepared_dashpot {
  T coefficient;  // kg/s
};

/// What a friction law sees.
template <Scalar T>
struct slip {
  Vec3<T> velocity;   // of the surface of i relative to that of j, in the tangent plane, m/s
  Vec3<T> normal;     // from i to j
  T tangential_mass;  // (2/7) reduced mass for two solid spheres free to roll, kg
  T contacts;         // touching neighbours of the two grains, mean weighted by inverse mass, at least 1
  double time_step;   // s
};

/// What a capillary or a rupture law sees.
template <Scalar T>
struct bridge {
  T gap;       // m; negative in overlap
  T volume;    // V_b, m3
  T radius_i;  // m
  T radius_j;  // m; wall_radius(radius_i) for a wall
};

/// Radius of a wall in a bridge, m: so large that the mean radii of the pair are those of a plane to the last bit, yet
/// finite, so that no formula in both radii meets infinity over infinity.
template <Scalar T>
T wall_radius(const T& radius) {
  return T(1e16) * radius;
}

/// A pair of radii beyond this ratio is a grain and a wall.
inline constexpr double largest_grain_ratio = 1e12;

/// Whether a bridge joins a grain and a wall.
inline bool is_at_wall(const bridge<double>& b) { return b.radius_j > largest_grain_ratio * b.radius_i; }

/// What a viscous bridge law answers: resistance to closing and to sliding, N s/m, both at least 0.
template <Scalar T>
struct bridge_resistance {
  T normal;
  T tangential;
};

/// The liquid, said once for law, rupture and the conversion of water content to volume.
struct fluid {
  double surface_tension;  // gamma_s, N/m
  double contact_angle;    // theta, rad, in [0, pi/2)
  double density;          // kg/m3
  double viscosity;        // Pa s

  /// Water on clean glass at 20 degrees C (CRC Handbook of Chemistry and Physics).
  static constexpr fluid water() { return {0.0728, 0.0, 998.2, 1.002e-3}; }
};

/// kappa = 2 pi gamma_s cos(theta), N/m (Richefeu et al. 2007, Eq. 5).
inline double capillary_tension(const fluid& f) {
  return 2.0 * std::numbers::pi * f.surface_tension * std::cos(f.contact_angle);
}

inline void validate(const fluid& f) {
  constexpr auto page = "docs/reference/laws.md";
  expects(f.surface_tension > 0 && std::isfinite(f.surface_tension), "the surface tension (N/m)", f.surface_tension,
          "positive and finite", page);
  expects(f.contact_angle >= 0 && f.contact_angle < std::numbers::pi / 2, "the contact angle (rad)", f.contact_angle,
          "in [0, pi/2)", page);
  expects(f.density > 0 && std::isfinite(f.density), "the liquid density (kg/m3)", f.density, "positive and finite",
          page);
  expects(f.viscosity >= 0 && std::isfinite(f.viscosity), "the liquid viscosity (Pa s)", f.viscosity,
          "at least 0 and finite", page);
}

}  // namespace pendular
