// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::rupture {

/// delta_max = R_h (1 + theta/4 (rho + 1)) (v^{1/3} + (rho/2 - 2/5) v^{2/3}),
/// rho = R_small / R_large, R_h = 2 R_i R_j / (R_i + R_j), v = V_b / R_h^3; equal spheres: R (1 + theta/2)(v^{1/3} + v^{2/3}/10).
/// Units: m from m, m3 and rad. Within -11 to +7 % of the Laplace-Young limit for size ratios up to 10, theta up to 60
/// degrees, V_b/R^3 in [1e-6, 0.1]; 10 % below to 1 % above it for planes. For rho < 4/5 the fit would fall with the volume
/// beyond v = (4/5 - rho)^-3; here the distance stays as it is there.
/// Source: Willett, Adams, Johnson and Seville 2000, Langmuir 16, 9396, normalised by the harmonic radius.
struct willett {
  static constexpr validity valid{.least_volume = 1e-6,
                                  .largest_volume = 0.1,
                                  .largest_ratio = 10,
                                  .largest_contact_angle = 1.0472,
                                  .planes = true};

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid& f) const {
    const T size_ratio = min(b.radius_i, b.radius_j) / max(b.radius_i, b.radius_j);
    const T radius = T(2) / T(T(1) / b.radius_i + T(1) / b.radius_j);
    const T turn = T(0.5) / max(T(T(0.4) - T(0.5) * size_ratio), T(tiny));
    const T length = min(T(cbrt(b.volume) / radius), turn);
    const T wetting = T(1) + T(0.25 * f.contact_angle) * (size_ratio + T(1));
    return radius * wetting * (length + (T(0.5) * size_ratio - T(0.4)) * length * length);
  }
};

}  // namespace pendular::rupture
