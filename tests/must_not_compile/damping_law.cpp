// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a damping law must be copyable
// expect 2: a damping law needs `template <Scalar T> T resistance(const approach<T>&, const T& stiffness) const`
// expect 3: resistance must return the scalar type of its approach
#include <pendular/law/check.hpp>

using namespace pendular;

struct my_law {
#if PENDULAR_MISTAKE == 1
  my_law(const my_law&) = delete;
#endif
#if PENDULAR_MISTAKE == 2
  template <Scalar T>
  T resistance(const approach<T>& a) const {
    return a.closing_speed;
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  Vec3<T> resistance(const approach<T>& a, const T&) const {
    return {a.closing_speed, T(0), T(0)};
  }
#else
  template <Scalar T>
  T resistance(const approach<T>& a, const T&) const {
    return a.closing_speed;
  }
#endif
};

static_assert(check::damping_law<my_law>);
