// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/check.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace pendular::boundary {

/// Marks a wall that grains share bridges with; the liquid wets it under the same contact angle.
struct wettable {};

/// A wall: its shape, what moves it, its contact law where that differs from the grains', and `wettable{}` where it
/// carries bridges.
template <class Shape, class Mover = fixed, class Material = none, class Wetting = none>
struct wall {
  static_assert(std::is_same_v<Wetting, none> || std::is_same_v<Wetting, wettable>,
                "the last part of a wall is wettable{} or nothing (docs/reference/boundary.md)");
  static constexpr bool is_wettable = std::is_same_v<Wetting, wettable>;
  static_assert(check::geometry<Shape>);
  static_assert(check::drive<Mover, Shape>);
  Shape shape;
  Mover drive;
  Material material;      // `none`: the material of the grains
  vector force{0, 0, 0};  // of the grains on the wall in the last step, N
  double work = 0;        // done by the wall on the grains since the start, J

  explicit wall(Shape s, Mover d = {}, Material m = {}, Wetting = {}) : shape(s), drive(d), material(m) {
    if constexpr (requires { validate(shape); }) validate(shape);
    if constexpr (requires { validate(drive); }) validate(drive);
    if constexpr (requires { drive.expect_shape(shape); }) drive.expect_shape(shape);
  }

  double approach_speed() const { return boundary::approach_speed(drive); }  // m/s

  void move(double time_step) {
    if constexpr (requires { drive.move(shape, load, time_step); }) {
      drive.move(shape, load, time_step);
    } else {
      drive.move(shape, force, time_step);
    }
  }

  /// The load of this step, after the wall has moved for `time_step`.
  void take(const wall_load& now, double time_step) {
    if constexpr (HasOneVelocity<Mover>) {
      work -= 0.5 * time_step * dot(force + now.force, vector(drive.velocity));
    } else {
      work += 0.5 * time_step * (load.power + now.power);
      load = now;
    }
    force = now.force;
  }

  [[no_unique_address]] std::conditional_t<HasOneVelocity<Mover>, none, wall_load> load = {};  // of the last step
};

template <class Shape>
wall(Shape) -> wall<Shape>;
template <class Shape, class Mover>
wall(Shape, Mover) -> wall<Shape, Mover>;
template <class Shape, class Mover, class Material>
wall(Shape, Mover, Material) -> wall<Shape, Mover, Material>;
template <class Shape, class Mover, class Material, class Wetting>
wall(Shape, Mover, Material, Wetting) -> wall<Shape, Mover, Material, Wetting>;

/// A boundary that is a list of walls.
template <class... Walls>
struct walls {
  std::tuple<Walls...> all;
  explicit walls(Walls... each) : all(each...) {}

  auto& parts() { return all; }
  const auto& parts() const { return all; }
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
