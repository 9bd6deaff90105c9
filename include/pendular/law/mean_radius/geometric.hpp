// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::mean_radius {

/// sqrt(R_i R_j), as printed in the paper; it knows no plane.
/// Units: m. In the amplitude of a capillary force 9 to 28 % high at a size ratio of 2, not to be used beyond 4
/// (docs/reference/laws.md).
/// Source: Richefeu et al. 2007, Eq. 4.
struct geometric {
  static constexpr validity valid{.largest_ratio = 4};

  template <Scalar T>
  T of(const bridge<T>& b) const {
    return capillary::geometric_radius(b);
  }
};

}  // namespace pendular::mean_radius
