// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/observe/solid_fraction.hpp>
#include <pendular/scene/lid.hpp>
#include <pendular/space/cell_grid.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace pendular::scene {

/// Six smooth planes around a sample, each loaded by a servo of its own. In the order of x, y and z: the low one, the
/// high one.
using smooth_contact = material<normal::linear, damping::viscous, energy_book>;
using box_wall = boundary::wall<boundary::plane, boundary::servo_stress, smooth_contact>;
using box_walls = boundary::walls<box_wall, box_wall, box_wall, box_wall, box_wall, box_wall>;

inline vector size_of(const box& room) { return room.upper - room.lower; }
inline double volume_of(const box& room) {
  const vector size = size_of(room);
  return size.x * size.y * size.z;
}

/// Where the six planes stand.
inline box room_of(const box_walls& w) {
  const auto at = [&](const box_wall& wall) { return wall.shape.point; };
  return {{at(get<0>(w)).x, at(get<2>(w)).y, at(get<4>(w)).z}, {at(get<1>(w)).x, at(get<3>(w)).y, at(get<5>(w)).z}};
}

namespace detail {
/// visit(wall, area that it closes, m2).
template <class Walls, class Visit>
void for_each_face(Walls& w, const Visit& visit) {
  const vector size = size_of(room_of(w));
  const std::array<double, 3> area{size.y * size.z, size.x * size.z, size.x * size.y};
  std::size_t face = 0;
  std::apply([&](auto&... wall) { (visit(wall, area[face++ / 2]), ...); }, w.all);
}
}  // namespace detail

/// Puts the planes where the room ends.
inline void enclose(box_walls& w, const box& room) {
  std::size_t face = 0;
  std::apply([&](auto&... wall) { ((wall.shape.point = face++ % 2 == 0 ? room.lower : room.upper), ...); }, w.all);
}

/// Sets the stress on all planes, Pa; the loaded areas become what the planes close now. A servo does not know that its
/// box shrinks, so whoever moves the walls far calls this again and again, at fixed step numbers. With a stress of 0 a
/// plane gives way while grains press on it, and its dashpot stops it where they no longer do: it neither presses nor
/// pulls.
inline void load_box(box_walls& w, double stress, double mass_scaling = 1) {
  detail::for_each_face(w, [&](box_wall& wall, double area) {
    const vector velocity = wall.drive.velocity;
    wall.drive = loading_lid(stress, area, mass_scaling);
    wall.drive.velocity = velocity;
  });
}

inline box_walls loaded_box(const box& room, double stress, const smooth_contact& m, double mass_scaling = 1) {
  const auto face = [&](const vector& point, const vector& normal) {
    return boundary::wall(boundary::plane{point, normal}, loading_lid(stress, 1), m);
  };
  box_walls w{face(room.lower, {1, 0, 0}),  face(room.upper, {-1, 0, 0}), face(room.lower, {0, 1, 0}),
              face(room.upper, {0, -1, 0}), face(room.lower, {0, 0, 1}),  face(room.upper, {0, 0, -1})};
  load_box(w, stress, mass_scaling);
  return w;
}

/// What the grains press on the walls with, mean of the six, Pa.
inline double mean_stress(const box_walls& w) {
  double sum = 0;
  detail::for_each_face(w,
                        [&](const box_wall& wall, double area) { sum -= dot(wall.force, wall.shape.normal) / area; });
  return sum / 6;
}

/// The upright cylinder about the z axis that stays so far away from all walls; it has no volume in a small box.
inline observe::upright_cylinder core_of(const box& room, double margin) {
  const double radius = std::min({-room.lower.x, -room.lower.y, room.upper.x, room.upper.y});
  return {radius - margin, room.lower.z + margin, room.upper.z - margin};
}

}  // namespace pendular::scene
