// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>

namespace pendular::mean_radius {

/// 2 R_i R_j / (R_i + R_j), twice the radius of the grain against a wall.
/// Units: m. Laplace-Young supports it in the amplitude of a capillary force as the volume vanishes, at any size ratio.
/// Source: B. V. Derjaguin, Kolloid-Z. 69, 155 (1934).
struct harmonic {
  template <Scalar T>
  T of(const bridge<T>& b) const {
    return capillary::harmonic_radius(b);
  }
};

}  // namespace pendular::mean_radius
