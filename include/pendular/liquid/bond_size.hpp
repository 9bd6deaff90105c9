// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

#include <cmath>

namespace pendular {

/// R^3 of V_b = alpha R^3, m3 (Richefeu et al. 2007, Eq. 14): R = sqrt(R_i R_j). At a wall, which the paper leaves out, it
/// is the radius of the grain, as if the wall were a grain of the same size.
inline double bond_size(const bridge<double>& b) {
  if (is_at_wall(b)) return b.radius_i * b.radius_i * b.radius_i;
  return std::pow(b.radius_i * b.radius_j, 1.5);
}

}  // namespace pendular
