// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a viscous bridge law must be copyable
// expect 2: a viscous bridge law needs `template <Scalar T> bridge_resistance<T> resistance(const bridge<T>&, const fluid&) const`
// expect 3: resistance of a bridge must return a bridge_resistance of the scalar type of its bridge
// expect 4: a viscous bridge law must take every scalar, not double alone
#include <pendular/law/check.hpp>

using namespace pendular;

struct my_law {
#if PENDULAR_MISTAKE == 1
  my_law(const my_law&) = delete;
#endif
#if PENDULAR_MISTAKE == 2
  template <Scalar T>
  bridge_resistance<T> resistance(const bridge<T>& b) const {
    return {b.volume, b.volume};
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  T resistance(const bridge<T>& b, const fluid&) const {
    return b.volume;
  }
#elif PENDULAR_MISTAKE == 4
  bridge_resistance<double> resistance(const bridge<double>& b, const fluid&) const { return {b.volume, b.volume}; }
#else
  template <Scalar T>
  bridge_resistance<T> resistance(const bridge<T>& b, const fluid&) const {
    return {b.volume, b.volume};
  }
#endif
};

static_assert(check::viscous_bridge_law<my_law>);
