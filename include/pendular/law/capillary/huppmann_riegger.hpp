// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

#include <numbers>

namespace pendular::capillary {

/// Toroid between equal spheres whose filling angle a gives it the volume of the bridge, p = a + theta:
///     r2 = (R (1 - cos a) + D/2) / cos p,  r1 = R sin a - r2 (1 - sin p),
///     f_c = 2 pi gamma R sin a sin p + pi gamma (R sin a)^2 (1/r2 - 1/r1).
/// The volume is that of the toroid less the caps of the spheres, exactly. The angle is found by a fixed number of steps
/// and kept so that p is below 80 degrees; a contact angle above 69 degrees counts as 69. R is the harmonic mean.
/// Units: N from N/m, m, m3 and rad.
/// Source: W. J. Huppmann, H. Riegger 1975, Acta Metall. 23, 965.
struct huppmann_riegger {
  static constexpr validity valid{1e-4, 0.1, 1.0001, 0.7};
  static constexpr double float_error = 5e-3;  // relative, where the neck all but vanishes

  template <class T>
  struct coefficients {
    T tension, radius, volume;  // N/m, m; V_b / R^3
    T angle;                    // theta, rad
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const T radius = harmonic_radius(b);
    return {T(f.surface_tension) + T(0) * radius, radius, reduced_volume(b.volume, radius, 1e-14),
            T(min(f.contact_angle, 1.2)) + T(0) * radius};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    const T half = T(0.5) * max(gap, T(0)) / c.radius;
    const T a = filling_angle(half, c);
    const toroid<T> t = at(a, half, c.angle);
    const T s = sin(a);
    const T pull = T(2) * s * t.sine + s * s * (T(1) / t.meridian - T(1) / t.neck);
    return T(std::numbers::pi) * c.tension * c.radius * max(pull, T(0));
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return attraction(b.gap, prepare(b, f));
  }

 private:
  template <class T>
  struct toroid {
    T meridian, neck, sine, volume;  // in units of R
  };

  template <class T>
  static toroid<T> at(const T& a, const T& half, const T& theta) {
    const T p = a + theta, cosine = cos(p), sine = sin(p);
    const T h = T(2) * sin(T(a / T(2))) * sin(T(a / T(2)));  // 1 - cos a
    const T r2 = max(T((h + half) / cosine), T(1e-30)), r1 = max(T(sin(a) - r2 * (T(1) - sine)), T(1e-30));
    const T outer = r1 + r2;
    const T body = T(2 * std::numbers::pi) * r2 *
                   (cosine * (outer * outer + r2 * r2 * (T(1) - cosine * cosine / T(3))) -
                    outer * r2 * (T(std::numbers::pi / 2) - p + sine * cosine));
    const T caps = T(2 * std::numbers::pi / 3) * h * h * (T(3) - h);
    return {r2, r1, sine, T(body - caps)};
  }

  template <class T>
  static T filling_angle(const T& half, const coefficients<T>& c) {
    const T most = T(1.39) - c.angle;
    const T area = T(2 / std::numbers::pi) * c.volume;
    T a = sqrt(T(area / (sqrt(T(T(4) * half * half + area)) + T(2) * half)));  // thin menisci
    for (int k = 0; k < 24; ++k) {
      a = min(a, most);
      const T h = T(0.5) * a * a;
      const T power = (T(4) * h + T(2) * half) / (h + half);  // V goes as a to this
      const T now = max(at(a, half, c.angle).volume, T(1e-18));
      a = a * exp(T(log(T(c.volume / now)) / power));
    }
    return min(a, most);
  }
};

}  // namespace pendular::capillary
