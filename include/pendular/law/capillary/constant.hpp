// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/pair_radius.hpp>
#include <pendular/law/validity.hpp>

namespace pendular::capillary {

/// f_c = kappa R_h from overlap to rupture: Derjaguin's force at contact, held over the whole gap. The simplest law that
/// is right as volume and gap vanish; N from N/m and m.
/// Source: B. V. Derjaguin, Kolloid-Z. 69, 155 (1934), for the amplitude.
struct constant {
  static constexpr validity valid{.planes = true};

  template <class T>
  struct coefficients {
    T amplitude;  // N
  };

  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    return {T(capillary_tension(f)) * harmonic_radius(b)};
  }

  template <Scalar T>
  T attraction(const T& gap, const coefficients<T>& c) const {
    return c.amplitude + T(0) * gap;
  }

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return attraction(b.gap, prepare(b, f));
  }

  /// Work from the gap of b to the rupture distance, J.
  template <Scalar T>
  T energy(const bridge<T>& b, const fluid& f, const T& rupture_distance) const {
    return prepare(b, f).amplitude * max(T(rupture_distance - b.gap), T(0));
  }
};

}  // namespace pendular::capillary
