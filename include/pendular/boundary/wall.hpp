// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/drive.hpp>
#include <pendular/core/none.hpp>

#include <concepts>
#include <tuple>

namespace pendular::boundary {

/// Shape of a wall.
template <class G>
concept Geometry = std::copyable<G> && requires(const G geometry, const vector centre, const double radius) {
  { geometry.meet(centre, radius) } -> std::convertible_to<meeting<double>>;
};

/// A wall: its shape, what moves it, and its contact law where that differs from the grains'. Walls carry no bridges.
template <class Shape, class Drive = fixed, class Material = none>
struct wall {
  static_assert(Geometry<Shape>,
                "a wall's shape needs `template <Scalar T> meeting<T> meet(const Vec3<T>& centre, const T& radius) "
                "const` (docs/reference/boundary.md)");
  Shape shape;
  Drive drive;
  Material material;      // `none`: the material of the grains
  vector force{0, 0, 0};  // of the grains on the wall in the last step, N
  double work = 0;        // done by the wall on the grains since the start, J

  explicit wall(Shape s, Drive d = {}, Material m = {}) : shape(s), drive(d), material(m) {
    if constexpr (requires { validate(shape); }) validate(shape);
    if constexpr (requires { validate(drive); }) validate(drive);
  }

  void move(double time_step) { drive.move(shape, force, time_step); }

  /// The force of this step, after the wall has moved for `time_step`.
  void take(const vector& now, double time_step) {
    work -= 0.5 * time_step * dot(force + now, vector(drive.velocity));
    force = now;
  }
};

template <class Shape>
wall(Shape) -> wall<Shape>;
template <class Shape, class Drive>
wall(Shape, Drive) -> wall<Shape, Drive>;
template <class Shape, class Drive, class Material>
wall(Shape, Drive, Material) -> wall<Shape, Drive, Material>;

/// All walls of a scene.
template <class... Walls>
struct walls {
  std::tuple<Walls...> all;
  explicit walls(Walls... each) : all(each...) {}
};

template <class... Walls>
walls(Walls...) -> walls<Walls...>;

template <std::size_t I, class... Walls>
auto& get(walls<Walls...>& w) {
  return std::get<I>(w.all);
}
template <std::size_t I, class... Walls>
const auto& get(const walls<Walls...>& w) {
  return std::get<I>(w.all);
}

}  // namespace pendular::boundary
