// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A boundary of a user's own, written from outside: sides with names in place of a list, and a lid that is no
// boundary::wall and remembers the hardest push on it. Scenes in it.
#include "../catch.hpp"

#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace sides {

using namespace pendular;
using boundary::plane;
using boundary::wall;

using rubber = material<normal::linear, damping::viscous, friction::coulomb_spring, energy_book>;
inline rubber grains_of(double stiffness, double damping = 0.3, double friction_spring = 800) {
  return material{normal::linear{stiffness}, damping::viscous{damping}, friction::coulomb_spring{friction_spring, 0.4},
                  energy_book{}};
}

// [wall]
/// A wall of one's own: a fixed lid that remembers how hard it was pushed at most.
struct measuring_lid {
  static constexpr bool is_wettable = false;
  plane shape;
  boundary::fixed drive;
  none material;  // that of the grains
  vector force{0, 0, 0};
  double work = 0;
  struct {
    double hardest = 0;  // N
  } load;                // is in checkpoints

  double approach_speed() const { return 0; }
  void move(double /*time_step*/) {}
  void take(const boundary::wall_load& now, double /*time_step*/) {
    force = now.force;
    load.hardest = std::max(load.hardest, norm(force));
  }
};
static_assert(check::wall<measuring_lid>);
// [/wall]

// [boundary]
/// A boundary of one's own: it knows its walls by name.
template <class Wetting, class Hard>
struct box_of_sides {
  wall<plane, boundary::constant_velocity, none, Wetting> floor;
  wall<plane> left, front, back;
  wall<plane, boundary::fixed, Hard> right;
  measuring_lid lid;

  auto parts() { return std::tie(floor, left, right, front, back, lid); }
  auto parts() const { return std::tie(floor, left, right, front, back, lid); }
};
static_assert(check::boundary<box_of_sides<boundary::wettable, none>>);
// [/boundary]

constexpr double radius = 0.5e-3, density = 2600, g = 9.81, k_n = 1e3, side = 6e-3;
constexpr double mass = 4.0 / 3 * std::numbers::pi * radius * radius * radius * density;

template <class Wetting, class Hard>
box_of_sides<Wetting, Hard> sides_of(const Wetting& wetting, const Hard& right) {
  return {wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0, 0, 0}}, none{}, wetting},
          wall{plane{{0, 0, 0}, {1, 0, 0}}},
          wall{plane{{0, 0, 0}, {0, 1, 0}}},
          wall{plane{{0, side, 0}, {0, -1, 0}}},
          wall{plane{{side, 0, 0}, {-1, 0, 0}}, boundary::fixed{}, right},
          {plane{{0, 0, side}, {0, 0, -1}}, {}, {}, {}, 0, {}}};
}
inline auto dry_sides(const rubber& right = grains_of(k_n)) { return sides_of(none{}, right); }

template <class Walls>
auto dry_scene(const Walls& walls, double damping = 0.3, double gravity = -g) {
  return pendular::system{grains_of(k_n, damping), walls, velocity_verlet{1e-6, {0, 0, gravity}}};
}

/// A few grains that fly about in all directions, rub and hit every side.
template <class System>
void fill(System& s) {
  for (int k = 0; k < 27; ++k) {
    const double x = k % 3 - 1, y = k / 3 % 3 - 1, z = k / 9 - 1;
    s.add({.position = {3e-3 + 1.9e-3 * x, 3e-3 + 1.9e-3 * y, 3e-3 + 1.9e-3 * z},
           .radius = radius,
           .density = density,
           .velocity = {0.3 * x - 0.2 * y, 0.3 * y + 0.1 * z, 0.3 * z - 0.2 * x}});
  }
}

template <class System>
std::vector<vector> all_that_moves(const System& s) {
  std::vector<vector> all;
  for (const std::size_t row : s.particles().rows_by_id()) {
    all.push_back(s.particles().template get<column::position>()[row]);
    all.push_back(s.particles().template get<column::velocity>()[row]);
    if constexpr (System::grains_type::rotate) {
      all.push_back(s.particles().template get<column::angular_velocity>()[row]);
    }
  }
  s.for_each_wall([&](const auto& one, const auto&) { all.insert(all.end(), {one.force, {one.work, 0, 0}}); });
  return all;
}

/// With what the lid remembers.
template <class System>
std::vector<vector> all_that_is_kept(const System& s) {
  auto all = all_that_moves(s);
  all.push_back({s.walls().lid.load.hardest, 0, 0});
  return all;
}

}  // namespace sides
