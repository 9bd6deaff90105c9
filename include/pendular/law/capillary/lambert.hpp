// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// f_c = 2 pi gamma R cos(theta) (1 - D / sqrt(D^2 + 2 V_b / (pi R))), R the harmonic mean: a meniscus of constant width
/// between nearly parallel surfaces.
/// Units: N from N/m, m, m3. Against Laplace-Young 4 to 27 % high at contact for V_b/R^3 in [1e-4, 0.1], 15 to 25 % low
/// beyond half of the rupture distance, at theta = 0.
/// Source: P. Lambert, A. Chau, A. Delchambre, S. Regnier 2008, Langmuir 24, 3157; the same as D. Maugis 1987, J. Adhes.
/// Sci. Technol. 1, 105, and the capillary term of O. Pitois et al. 2000, J. Colloid Interface Sci. 231, 26.
struct lambert {
  static constexpr validity valid{.largest_volume = 0.1, .largest_contact_angle = 0.3491, .planes = true};

  template <class T>
  struct coefficients {
    T amplitude;  // N
    T area;       // 2 V_b / (pi R), m2
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = harmonic_radius(b);
    return {T(capillary_tension(f)) * radius,
            T(T(2 / std::numbers::pi) * radius * radius * reduced_volume(b.volume, radius, 1e-20))};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    const T d = max(gap, T(0));
    return c.amplitude * meniscus(d, T(sqrt(T(d * d + c.area))), c.area);
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return attraction(b.gap, prepare(b, f));
  }

  /// Work from the gap of b to the rupture distance, J.
  template <Scalar T>
  T energy(const bridge<T>& b, const fluid& f, const T& rupture_distance) const {
    const coefficients<T> c = prepare(b, f);
    const T from = min(T(max(b.gap, T(0))), rupture_distance), overlap = max(T(-b.gap), T(0));
    const auto length = [&](const T& d) { return T(sqrt(T(d * d + c.area))); };
    const auto left = [&](const T& d) { return T(c.area / (length(d) + d)); };
    const T spent = left(from) - left(rupture_distance);
    return c.amplitude * (spent + overlap);
  }

 private:
  /// 1 - d / l with l^2 = d^2 + area, without cancellation.
  template <class T>
  static T meniscus(const T& d, const T& l, const T& area) {
    return area / (l * (l + d));
  }
};

}  // namespace pendular::capillary
