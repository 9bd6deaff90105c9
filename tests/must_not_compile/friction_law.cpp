// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a friction law must be copyable
// expect 2: a friction law needs `template <Scalar T> Vec3<T> traction(const slip<T>&, const T& normal_force) const`
// expect 3: traction must return a Vec3 of the scalar type of its slip
// expect 4: with a third argument `contact_memory<T>&`, a nested template, if it remembers
// expect 5: with a third argument `contact_memory<T>&`, a nested template, if it remembers
// expect 6: a friction law must take every scalar, not double alone
// expect 7: traction must return a Vec3 of the scalar type of its slip: write Vec3<T>
#include <pendular/law/check.hpp>

using namespace pendular;

struct my_law {
#if PENDULAR_MISTAKE == 1
  my_law(const my_law&) = delete;
#endif
#if PENDULAR_MISTAKE == 5
  template <Scalar T, class Memory>
  Vec3<T> traction(const slip<T>& s, const T&, Memory&) const {
    return -s.velocity;
  }
#elif PENDULAR_MISTAKE == 4
  template <class T>
  struct memory_of_contact {
    Vec3<T> force;
  };
  template <Scalar T>
  Vec3<T> traction(const slip<T>&, const T&, memory_of_contact<T>& memory) const {
    return memory.force;
  }
#elif PENDULAR_MISTAKE == 2
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s) const {
    return -s.velocity;
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  T traction(const slip<T>& s, const T&) const {
    return -norm(s.velocity);
  }
#elif PENDULAR_MISTAKE == 6
  Vec3<double> traction(const slip<double>& s, double normal_force) const {
    return shortened_to(-s.velocity, normal_force);
  }
#elif PENDULAR_MISTAKE == 7
  template <class T>
  struct times {
    T factor;
    const Vec3<T>& vector;
    operator Vec3<T>() const { return factor * vector; }
  };
  template <Scalar T>
  times<T> traction(const slip<T>& s, const T&) const {
    return {T(-1), s.velocity};
  }
#else
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force) const {
    return shortened_to(Vec3<T>(-s.velocity), normal_force);
  }
#endif
};

static_assert(check::friction_law<my_law>);
