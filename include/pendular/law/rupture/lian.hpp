// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::rupture {

/// delta_max = (1 + theta/2) V_b^{1/3}.
/// Units: m from m3 and rad. Within -5 to +7 % of the Laplace-Young limit for equal spheres, theta up to 60 degrees,
/// V_b/R^3 in [1e-6, 0.1]; up to 47 % high at a size ratio of 10.
/// Source: Lian, Thornton and Adams 1993, J. Colloid Interface Sci. 161, 138; Richefeu et al. 2007, Eq. 6.
struct lian {
  static constexpr validity valid{1e-6, 0.1, 4, 1.0472};

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid& f) const {
    return T(1.0 + 0.5 * f.contact_angle) * cbrt(b.volume);
  }
};

}  // namespace pendular::rupture
