// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a normal law must be copyable
// expect 2: a normal law needs `template <Scalar T> T repulsion(const approach<T>&) const`
// expect 3: repulsion must return the scalar type of its approach
// expect 4: a normal law must take every scalar, not double alone
// expect 5: repulsion must return the scalar type of its approach: write T
// expect 6: with a second argument `contact_memory<T>&`, a nested template, if it remembers
#include <pendular/law/check.hpp>

using namespace pendular;

struct my_law {
#if PENDULAR_MISTAKE == 1
  my_law(const my_law&) = delete;
#endif
#if PENDULAR_MISTAKE == 2
  template <Scalar T>
  T repulsion(const bridge<T>& a) const {
    return -a.gap;
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  void repulsion(const approach<T>&) const {}
#elif PENDULAR_MISTAKE == 4
  double repulsion(const approach<double>& a) const { return max(-a.gap, 0.0); }
#elif PENDULAR_MISTAKE == 5
  template <Scalar T>
  auto repulsion(const approach<T>& a) const {
    return T(2) * max(T(-a.gap), T(0));
  }
#else
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    return max(T(-a.gap), T(0));
  }
#endif
};

static_assert(check::normal_law<my_law>);

struct my_law_with_memory {
#if PENDULAR_MISTAKE == 6
  template <class T>
  struct memory {
    T deepest;
  };
  template <Scalar T>
  T repulsion(const approach<T>& a, memory<T>& own) const {
    return max(T(-a.gap), own.deepest);
  }
#else
  template <class T>
  struct contact_memory {
    T deepest;
  };
  template <Scalar T>
  T repulsion(const approach<T>& a, contact_memory<T>& own) const {
    return max(T(-a.gap), own.deepest);
  }
#endif
};
static_assert(check::normal_law<my_law_with_memory>);
