// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a capillary law must be copyable
// expect 2: a capillary law needs `template <Scalar T> T attraction(const bridge<T>&, const fluid&) const`
// expect 3: attraction must return the scalar type of its bridge
// expect 4: must return its nested template `coefficients<T>` from it
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
#else
  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return T(capillary_tension(f)) * b.radius_i;
  }
#endif
};

static_assert(check::capillary_law<my_bridge>);
