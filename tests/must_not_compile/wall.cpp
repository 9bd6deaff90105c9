// SPDX-License-Identifier: BSD-3-Clause
// expect: a wall's shape needs `template <Scalar T> meeting<T> meet(const Vec3<T>& centre, const T& radius) const`
#include <pendular/boundary/wall.hpp>

using namespace pendular;

struct ceiling {
  double height;  // m
#ifdef PENDULAR_MISTAKE
  template <Scalar T>
  T gap(const Vec3<T>& centre, const T& radius) const {
    return T(height) - centre.z - radius;
  }
#else
  template <Scalar T>
  boundary::meeting<T> meet(const Vec3<T>& centre, const T& radius) const {
    return {T(height) - centre.z - radius, {T(0), T(0), T(1)}};
  }
#endif
};

double height_of_a_room() {
  const boundary::wall room{ceiling{2.5}};
  return room.shape.height;
}
