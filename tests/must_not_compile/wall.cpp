// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a wall's shape needs `template <Scalar T> meeting<T> meet(const Vec3<T>& centre, const T& radius) const`
// expect 2: a wall's drive needs a `velocity`, or `velocity_at(point)`, `pivot()` and `approach_speed()`, and `void move(shape, load, time_step)`
#include <pendular/boundary/wall.hpp>

using namespace pendular;

struct ceiling {
  double height;  // m
#if PENDULAR_MISTAKE == 1
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

struct lift {
  vector velocity;  // m/s
#if PENDULAR_MISTAKE != 2
  void move(ceiling& c, const vector&, double time_step) { c.height += time_step * velocity.z; }
#endif
};

double height_of_a_room() {
  const boundary::wall room{ceiling{2.5}, lift{{0, 0, 1}}};
  return room.shape.height;
}
