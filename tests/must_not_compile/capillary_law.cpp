// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a capillary law must be copyable
// expect 2: a capillary law needs `template <Scalar T> T attraction(const bridge<T>&, const fluid&) const`
// expect 3: attraction must return the scalar type of its bridge
// expect 4: must return its nested template `coefficients<T>` from it
// expect 5: a capillary law must take every scalar, not double alone
// expect 6: attraction must return the scalar type of its bridge: write T
// expect 7: a capillary law must take every scalar, not double alone
// expect 8: attraction must return the scalar type of its bridge: write T
#include <pendular/law/check.hpp>

using namespace pendular;

struct my_bridge {
#if PENDULAR_MISTAKE == 1
  my_bridge(const my_bridge&) = delete;
#endif
#if PENDULAR_MISTAKE == 2
  template <Scalar T>
  T attraction(const bridge<T>& b) const {
    return b.radius_i;
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  bridge<T> attraction(const bridge<T>& b, const fluid&) const {
    return b;
  }
#elif PENDULAR_MISTAKE == 4
  template <Scalar T>
  T prepare(const bridge<T>& b, const fluid&) const {
    return b.radius_i;
  }
  template <Scalar T>
  T attraction(const T&, const T& c) const {
    return c;
  }
#elif PENDULAR_MISTAKE == 5
  double attraction(const bridge<double>& b, const fluid& f) const { return capillary_tension(f) * b.radius_i; }
#elif PENDULAR_MISTAKE == 6
  template <Scalar T>
  auto attraction(const bridge<T>& b, const fluid& f) const {
    const auto mean = T(2) * b.radius_i * b.radius_j / (b.radius_i + b.radius_j);
    return T(capillary_tension(f)) * mean;
  }
#elif PENDULAR_MISTAKE == 7
  template <class T>
  struct coefficients {
    T force;
  };
  coefficients<double> prepare(const bridge<double>& b, const fluid&) const { return {b.radius_i}; }
  template <Scalar T>
  T attraction(const T&, const coefficients<T>& c) const {
    return c.force;
  }
#elif PENDULAR_MISTAKE == 8
  template <class T>
  struct coefficients {
    T force;
  };
  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid&) const {
    return {b.radius_i};
  }
  template <Scalar T>
  auto attraction(const T&, const coefficients<T>& c) const {
    return T(2) * c.force;
  }
#else
  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return T(capillary_tension(f)) * b.radius_i;
  }
#endif
};

static_assert(check::capillary_law<my_bridge>);
