// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a wall's shape needs `template <Scalar T> meeting<T> meet(const Vec3<T>& centre, const T& radius) const`
// expect 2: a wall's drive needs `void move(shape, load, time_step)` for the shape of its wall
// expect 3: a wall's drive needs a `velocity`, or `velocity_at(point)`, `pivot()` and `approach_speed()`
// expect 4: a wall's shape must take every scalar, not double alone
// expect 5: meet must return a boundary::meeting of the scalar type of its radius
// expect 6: a drive's velocity_at must take every scalar, not double alone
// expect 7: velocity_at must return a Vec3 of the scalar type of its point
// expect 8: a wall's shape must be copyable
// expect 9: a wall's drive must be copyable
#include <pendular/boundary/wall.hpp>

#include <memory>

using namespace pendular;

struct ceiling {
  double height;  // m
#if PENDULAR_MISTAKE == 1
  template <Scalar T>
  T gap(const Vec3<T>& centre, const T& radius) const {
    return T(height) - centre.z - radius;
  }
#elif PENDULAR_MISTAKE == 4
  boundary::meeting<double> meet(const Vec3<double>& centre, double radius) const {
    return {height - centre.z - radius, {0, 0, 1}};
  }
#elif PENDULAR_MISTAKE == 5
  template <Scalar T>
  auto meet(const Vec3<T>& centre, const T& radius) const {
    struct touch {
      T distance;
      operator boundary::meeting<T>() const { return {distance, {T(0), T(0), T(1)}}; }
    };
    return touch{T(height) - centre.z - radius};
  }
#else
  template <Scalar T>
  boundary::meeting<T> meet(const Vec3<T>& centre, const T& radius) const {
    return {T(height) - centre.z - radius, {T(0), T(0), T(1)}};
  }
#endif
#if PENDULAR_MISTAKE == 8
  std::unique_ptr<double> paint = nullptr;
#endif
};

struct lift {
#if PENDULAR_MISTAKE == 3
  vector speed;
#else
  vector velocity;  // m/s
#endif
#if PENDULAR_MISTAKE == 9
  std::unique_ptr<double> motor = nullptr;
#endif
#if PENDULAR_MISTAKE != 2
  void move(ceiling& c, const vector&, double time_step) { c.height += time_step; }
#endif
};

/// A ceiling fan.
struct fan {
  double rate;  // rad/s
#if PENDULAR_MISTAKE == 6
  vector velocity_at(const vector& p) const { return {-rate * p.y, rate * p.x, 0}; }
#elif PENDULAR_MISTAKE == 7
  template <Scalar T>
  auto velocity_at(const Vec3<T>& p) const {
    struct flow {
      T x, y;
      operator Vec3<T>() const { return {x, y, T(0)}; }
    };
    return flow{T(-rate) * p.y, T(rate) * p.x};
  }
#else
  template <Scalar T>
  Vec3<T> velocity_at(const Vec3<T>& p) const {
    return {T(-rate) * p.y, T(rate) * p.x, T(0)};
  }
#endif
  vector pivot() const { return {0, 0, 0}; }
  double approach_speed() const { return 0; }
  void move(ceiling&, const boundary::wall_load&, double) {}
};

double height_of_a_room() {
  const boundary::wall stirred{ceiling{2.5}, fan{1}};
  const boundary::wall room{ceiling{2.5}, lift{{0, 0, 1}}};
  return room.shape.height - stirred.shape.height;
}
