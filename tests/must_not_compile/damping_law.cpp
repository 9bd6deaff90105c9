// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a damping law must be copyable
// expect 2: a damping law needs `template <Scalar T> T resistance(const approach<T>&, const T& stiffness) const`
// expect 3: resistance must return the scalar type of its approach
// expect 4: a damping law must take every scalar, not double alone
// expect 5: resistance must return the scalar type of its approach: write T
// expect 6: a damping law must take every scalar, not double alone
// expect 7: or `const elastic<T>&` in place of the stiffness
// expect 8: a damping law must take every scalar, not double alone
// expect 9: resistance must return the scalar type of its approach: write T
// expect 10: with a last argument `contact_memory<T>&`, a nested template, if it remembers
// expect 11: damping::clamped takes a damping law, such as clamped{viscous{0.8}}
#include <pendular/law/check.hpp>
#include <pendular/law/damping/clamped.hpp>
#include <pendular/law/rupture/lian.hpp>

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

struct my_law_beside_spring {
#if PENDULAR_MISTAKE == 7
  template <Scalar T>
  T resistance(const approach<T>& a, const T& push, const T& stiffness) const {
    return push * stiffness * a.closing_speed;
  }
#elif PENDULAR_MISTAKE == 8
  double resistance(const approach<double>& a, const elastic<double>& spring) const {
    return spring.push * a.closing_speed;
  }
#elif PENDULAR_MISTAKE == 9
  template <Scalar T>
  auto resistance(const approach<T>& a, const elastic<T>& spring) const {
    return spring.push * a.closing_speed;
  }
#else
  template <Scalar T>
  T resistance(const approach<T>& a, const elastic<T>& spring) const {
    return spring.push * a.closing_speed;
  }
#endif
};
static_assert(check::damping_law<my_law_beside_spring>);

struct my_law_with_memory {
#if PENDULAR_MISTAKE == 10
  template <class T>
  struct memory {
    T fastest;
  };
  template <Scalar T>
  T resistance(const approach<T>& a, const T&, memory<T>& own) const {
    return own.fastest * a.closing_speed;
  }
#else
  template <class T>
  struct contact_memory {
    T fastest;
  };
  template <Scalar T>
  T resistance(const approach<T>& a, const T&, contact_memory<T>& own) const {
    return own.fastest * a.closing_speed;
  }
#endif
};
static_assert(check::damping_law<my_law_with_memory>);

#if PENDULAR_MISTAKE == 11
const damping::clamped wrapped{rupture::lian{}};
#else
const damping::clamped wrapped{my_law_with_memory{}};
#endif
static_assert(check::damping_law<damping::clamped<my_law_with_memory>>);
