// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

namespace pendular {

namespace detail {
template <class T>
struct volume_and_radii {
  T volume, radius_i, radius_j;
};

template <class Law, class T>
struct coefficients_of {
  using type = volume_and_radii<T>;
};
template <class Law, class T>
  requires Prepares<Law, double>
struct coefficients_of<Law, T> {
  using type = typename Law::template coefficients<T>;
};
}  // namespace detail

/// What is cached per bond: the law's own coefficients, or volume and radii for a law without `prepare`.
template <class Law, class T>
using coefficients_t = typename detail::coefficients_of<Law, T>::type;

/// Done when a volume or a pair changes.
template <CapillaryLaw Law>
coefficients_t<Law, double> prepare(const Law& law, const bridge<double>& b, const fluid& f) {
  if constexpr (detail::Prepares<Law, double>) {
    return law.prepare(b, f);
  } else {
    return {b.volume, b.radius_i, b.radius_j};
  }
}

/// Done every step: pull, N.
template <CapillaryLaw Law, Scalar T>
T attraction(const Law& law, const T& gap, const coefficients_t<Law, T>& c, const fluid& f) {
  if constexpr (detail::Prepares<Law, double>) {
    return law.attraction(gap, c);
  } else {
    return law.attraction(bridge<T>{gap, c.volume, c.radius_i, c.radius_j}, f);
  }
}

/// Work from the gap to the rupture distance, J, of a law that knows it: from the coefficients where the law can.
template <HasCapillaryEnergy Law>
double energy(const Law& law, const bridge<double>& b, const coefficients_t<Law, double>& c, const fluid& f,
              double rupture_distance) {
  if constexpr (requires { law.energy(b.gap, c, rupture_distance); }) {
    return law.energy(b.gap, c, rupture_distance);
  } else {
    return law.energy(b, f, rupture_distance);
  }
}

}  // namespace pendular
