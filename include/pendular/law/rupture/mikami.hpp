// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::rupture {

/// delta_max = R (0.99 + 0.62 theta) v^0.34, v = V_b/R^3, R the harmonic mean radius.
/// Units: m from m, m3 and rad. For equal spheres; 5 to 8 % below Laplace-Young at theta = 0, V_b/R^3 in [1e-4, 0.1].
/// Source: T. Mikami, H. Kamiya, M. Horio 1998, Chem. Eng. Sci. 53, 1927.
struct mikami {
  static constexpr validity valid{1e-4, 0.1, 1.0001, 0.35};

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid& f) const {
    const T radius = T(2) / T(T(1) / b.radius_i + T(1) / b.radius_j);
    const T v = b.volume / (radius * radius * radius);
    return radius * T(0.99 + 0.62 * f.contact_angle) * pow(max(v, T(tiny)), 0.34) * unit_step(v);
  }
};

}  // namespace pendular::rupture
