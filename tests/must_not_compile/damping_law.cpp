// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a damping law must be copyable
// expect 2: a damping law needs `template <Scalar T> T resistance(const approach<T>&, const T& stiffness) const`
// expect 3: resistance must return the scalar type of its approach
// expect 4: a damping law must take every scalar, not double alone
// expect 5: resistance must return the scalar type of its approach: write T
// expect 6: a damping law must take every scalar, not double alone
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
#elif PENDULAR_MISTAKE == 4
  double resistance(const approach<double>& a, double) const { return a.closing_speed; }
#elif PENDULAR_MISTAKE == 5
  template <Scalar T>
  auto resistance(const approach<T>& a, const T& stiffness) const {
    return stiffness * a.closing_speed;
  }
#else
  template <Scalar T>
  T resistance(const approach<T>& a, const T&) const {
    return a.closing_speed;
  }
#if PENDULAR_MISTAKE == 6
  prepared_dashpot<double> prepare(double, double stiffness) const { return {stiffness}; }
#else
  template <Scalar T>
  prepared_dashpot<T> prepare(const T&, const T& stiffness) const {
    return {stiffness};
  }
#endif
  template <Scalar T>
  T resistance(const approach<T>& a, const prepared_dashpot<T>&) const {
    return a.closing_speed;
  }
#endif
};

static_assert(check::damping_law<my_law>);
