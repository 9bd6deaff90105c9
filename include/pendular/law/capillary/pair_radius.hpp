// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::capillary {

/// Harmonic (Derjaguin) mean 2 R_i R_j / (R_i + R_j), m; 2 R_i against a wall.
template <Scalar T>
T harmonic_radius(const bridge<T>& b) {
  return T(2) / T(T(1) / b.radius_i + T(1) / b.radius_j);
}

/// Geometric mean, m. Meaningless against a wall.
template <Scalar T>
T geometric_radius(const bridge<T>& b) {
  return sqrt(T(b.radius_i * b.radius_j));
}

/// V_b / R^3, kept above `least` so that logarithms and negative powers stay finite as the volume vanishes.
template <Scalar T>
T reduced_volume(const T& volume, const T& radius, double least) {
  return max(T(volume / T(radius * radius * radius)), T(least));
}
/// The same kept below `most` too, for fits that turn beyond it.
template <Scalar T>
T reduced_volume(const T& volume, const T& radius, double least, double most) {
  return min(reduced_volume(volume, radius, least), T(most));
}

}  // namespace pendular::capillary
