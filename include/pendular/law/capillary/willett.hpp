// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// f_c = 2 pi gamma R exp(f1 - f2 exp(f3 ln S + f4 ln^2 S)), S = (D/2) / sqrt(V_b/R): a fit to Laplace-Young with
/// f1 to f4 polynomials in ln(V_b/R^3) and theta. For equal spheres; with the harmonic mean R for any size ratio.
/// Below V_b/R^3 = 1e-6, where the fit turns, and above 1 the polynomials stay at their values there.
/// Units: N from N/m, m, m3 and rad. Against Laplace-Young within 3 % (5 % at 50 degrees) up to three quarters of the
/// rupture distance for V_b/R^3 in [1e-4, 0.1] and theta to 50 degrees; 15 to 93 % high at that gap for 1e-5.
/// Source: C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville 2000, Langmuir 16, 9396, appendix A1.
struct willett {
  static constexpr validity valid{
      .least_volume = 1e-4, .largest_volume = 0.1, .largest_contact_angle = 0.8727, .planes = true};

  template <class T>
  struct coefficients {
    T amplitude;  // 2 pi gamma R exp(f1), N
    T stretch;    // S / D, 1/m
    T f2, f3, f4;
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    const double t = f.contact_angle, q = t * t;
    const T radius = harmonic_radius(b);
    const T x = log(reduced_volume(b.volume, radius, 1e-6, 1));
    const auto cubic = [&](double a0, double a1, double a2, double a3) {
      return T(T(a0) + x * (T(a1) + x * (T(a2) + x * T(a3))));
    };
    const T f1 = cubic(-0.44507 + 0.050832 * t - 1.1466 * q, -0.1119 - 0.000411 * t - 0.1490 * q,
                       -0.012101 - 0.0036456 * t - 0.01255 * q, -0.0005 - 0.0003505 * t - 0.00029076 * q);
    const T f2 = cubic(1.9222 - 0.57473 * t - 1.2918 * q, -0.0668 - 0.1201 * t - 0.22574 * q,
                       -0.0013375 - 0.0068988 * t - 0.01137 * q, 0);
    const T f3 = cubic(1.268 - 0.01396 * t - 0.23566 * q, 0.198 + 0.092 * t - 0.06418 * q,
                       0.02232 + 0.02238 * t - 0.009853 * q, 0.0008585 + 0.001318 * t - 0.00053 * q);
    const T f4 = cubic(-0.010703 + 0.073776 * t - 0.34742 * q, 0.03345 + 0.04543 * t - 0.09056 * q,
                       0.0018574 + 0.004456 * t - 0.006257 * q, 0);
    const T stretch = T(0.5) / (radius * sqrt(reduced_volume(b.volume, radius, 1e-30)));
    return {T(2 * std::numbers::pi * f.surface_tension) * radius * exp(f1), stretch, f2, f3, f4};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    const T s = log(max(T(max(gap, T(0)) * c.stretch), T(1e-12)));
    return c.amplitude * exp(T(-c.f2 * exp(T(s * (c.f3 + c.f4 * s)))));
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return attraction(b.gap, prepare(b, f));
  }
};

}  // namespace pendular::capillary
