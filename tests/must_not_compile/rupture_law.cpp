// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a rupture law must be copyable
// expect 2: a rupture law needs `template <Scalar T> T distance(const bridge<T>&, const fluid&) const`
// expect 3: distance must return the scalar type of its bridge
// expect 4: a rupture law must take every scalar, not double alone
// expect 5: distance must return the scalar type of its bridge: write T
#include <pendular/law/check.hpp>

using namespace pendular;

struct my_law {
#if PENDULAR_MISTAKE == 1
  my_law(const my_law&) = delete;
#endif
#if PENDULAR_MISTAKE == 2
  template <Scalar T>
  T rupture_distance(const bridge<T>& b, const fluid&) const {
    return pendular::cbrt(b.volume);
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  void distance(const bridge<T>&, const fluid&) const {}
#elif PENDULAR_MISTAKE == 4
  double distance(const bridge<double>& b, const fluid&) const { return pendular::cbrt(b.volume); }
#elif PENDULAR_MISTAKE == 5
  template <Scalar T>
  auto distance(const bridge<T>& b, const fluid&) const {
    return T(2) * pendular::cbrt(b.volume);
  }
#else
  template <Scalar T>
  T distance(const bridge<T>& b, const fluid&) const {
    return pendular::cbrt(b.volume);
  }
#endif
};

static_assert(check::rupture_law<my_law>);
