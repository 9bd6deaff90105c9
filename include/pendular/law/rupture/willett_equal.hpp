// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::rupture {

/// delta_max = R (1 + theta/2) (v^{1/3} + v^{2/3}/10), v = V_b/R^3, R the harmonic mean radius.
/// Units: m from m, m3 and rad. For equal spheres, below 31 degrees within 5 % of Laplace-Young; for any size ratio as
/// other codes use it.
/// Source: C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville 2000, Langmuir 16, 9396.
struct willett_equal {
  static constexpr validity valid{1e-6, 0.1, 1.0001, 0.5411};

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid& f) const {
    const T radius = T(2) / T(T(1) / b.radius_i + T(1) / b.radius_j);
    const T length = cbrt(b.volume) / radius;
    return radius * T(1 + 0.5 * f.contact_angle) * (length + T(0.1) * length * length);
  }
};

}  // namespace pendular::rupture
