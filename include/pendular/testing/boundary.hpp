// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/concepts.hpp>
#include <pendular/testing/drive.hpp>
#include <pendular/testing/geometry.hpp>

#include <cmath>
#include <string>
#include <tuple>
#include <type_traits>

namespace pendular::testing {

namespace detail {
/// A wall moves with its drive, and tells what it is told.
template <boundary::Wall W>
void demand_wall(report& broken, const W& wall, const box& room, double time_step) {
  W moved = wall;
  moved.take({{1, 2, 3}, {0, 0, 0}, 5}, 0);
  const double standing = moved.work;
  demand(broken, vector(moved.force) == vector{1, 2, 3}, "a wall must have the force that it was told", {});
  demand(broken, standing == wall.work, "a wall does no work while the scene stands", {{"work", standing}});
  moved.take({{1, 2, 3}, {0, 0, 0}, 5}, time_step);
  double power = 5;
  if constexpr (boundary::HasOneVelocity<std::remove_cvref_t<decltype(wall.drive)>>) {
    power = -dot(vector{1, 2, 3}, vector(wall.drive.velocity));
  }
  demand(broken, std::abs(moved.work - standing - time_step * power) <= 1e-12 * time_step * (1 + std::abs(power)),
         "the work of a wall must be its power times the time step", {{"work", moved.work - standing}});
  demand(broken, wall.approach_speed() >= boundary::approach_speed(wall.drive) * (1 - 1e-12),
         "the approach speed of a wall must be at least that of its drive", {{"found", wall.approach_speed()}});
  W stepped = wall;
  auto shape = wall.shape;
  auto drive = wall.drive;
  stepped.move(time_step);
  detail::move(drive, shape, {vector(wall.force), {}, 0}, time_step);
  for (const sphere<double>& s : sphere_samples(room, 16)) {
    const double found = stepped.shape.meet(s.centre, s.radius).gap, said = shape.meet(s.centre, s.radius).gap;
    demand(broken, std::abs(found - said) <= 1e-12 * norm(room.upper - room.lower),
           "a wall must move as its drive moves it", {{"gap", found}, {"by the drive", said}});
  }
}

template <class W>
void append_parts(report& broken, const W& wall, std::size_t place, const box& room, double time_step) {
  report own = geometry_report(wall.shape, room);
  for (const report& more : {drive_report(wall.drive, wall.shape, room, time_step)}) {
    own.insert(own.end(), more.begin(), more.end());
  }
  demand_wall(own, wall, room, time_step);
  for (const std::string& line : own) broken.push_back("part " + std::to_string(place) + ": " + line);
}

/// Parts are those of the boundary that is asked, and of no other.
template <boundary::Boundary B>
void demand_own_parts(report& broken, const B& boundary) {
  B first = boundary;
  B copy = first;
  const auto inside = [](const B& whole, const auto& part) {
    const auto* begin = reinterpret_cast<const char*>(&whole);
    const auto* here = reinterpret_cast<const char*>(&part);
    return begin <= here && here < begin + sizeof whole;
  };
  std::size_t of_first = 0, of_copy = 0;
  const auto touch = [&](auto& part) { part.take({{7, 0, 0}, {}, 0}, 0), of_first += inside(first, part); };
  const auto look = [&](const auto& part) { of_copy += inside(copy, part) || vector(part.force) != vector{7, 0, 0}; };
  auto&& parts = first.parts();
  std::apply([&](auto&... part) { (touch(part), ...); }, parts);
  auto&& others = std::as_const(copy).parts();
  std::apply([&](const auto&... part) { (look(part), ...); }, others);
  constexpr std::size_t count = std::tuple_size_v<std::remove_cvref_t<decltype(parts)>>;
  demand(broken, of_copy == count, "a copy of a boundary must answer parts of its own",
         {{"parts", static_cast<double>(count)}, {"of its own", static_cast<double>(of_copy)}});
  std::size_t seen = 0;
  auto&& again = std::as_const(first).parts();
  std::apply([&](const auto&... part) { ((seen += vector(part.force) == vector{7, 0, 0}), ...); }, again);
  demand(broken, seen == count, "parts of a boundary that is const must be those of one that is not",
         {{"parts", static_cast<double>(count)}, {"the same", static_cast<double>(seen)}});
}
}  // namespace detail

/// What a boundary and its walls promise beyond their signatures, for grains in a room (m).
template <boundary::Boundary B>
report boundary_report(const B& boundary, const box& room, double time_step = 1e-7) {
  report broken;
  detail::demand_own_parts(broken, boundary);
  std::size_t place = 0;
  auto&& parts = boundary.parts();
  std::apply([&](const auto&... part) { (detail::append_parts(broken, part, place++, room, time_step), ...); }, parts);
  return broken;
}

}  // namespace pendular::testing
