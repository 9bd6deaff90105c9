// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/concepts.hpp>
#include <pendular/core/lanes.hpp>
#include <pendular/testing/geometry.hpp>
#include <pendular/testing/report.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pendular::testing {

namespace detail {
/// Velocity of the surface at a point, m/s.
template <class D>
vector surface_velocity(const D& drive, const vector& point) {
  if constexpr (boundary::HasOneVelocity<D>) {
    return drive.velocity;
  } else {
    return drive.velocity_at(point);
  }
}

template <class D, class G>
void move(D& drive, G& shape, const boundary::wall_load& load, double time_step) {
  if constexpr (requires { drive.move(shape, load, time_step); }) {
    drive.move(shape, load, time_step);
  } else {
    drive.move(shape, load.force, time_step);
  }
}

/// A step moves the surface as the drive says that it moves, by the velocity before the step or after it.
template <class D, class G>
void demand_motion(report& broken, const D& drive, const G& shape, const boundary::wall_load& load,
                   const sphere<double>& s, double time_step) {
  D moved = drive;
  G there = shape;
  detail::move(moved, there, load, time_step);
  const boundary::meeting<double> m = shape.meet(s.centre, s.radius);
  const vector point = s.centre + (s.radius + m.gap) * m.normal;
  const vector was = surface_velocity(drive, point), is = surface_velocity(moved, point);
  const double before = dot(was, m.normal), after = dot(is, m.normal);
  const double found = (there.meet(s.centre, s.radius).gap - m.gap) / time_step;
  const double granted = std::abs(after - before) + 1e-4 * (norm(was) + norm(is)) + 1e-7;
  const std::initializer_list<quantity> at = {{"x", point.x},         {"y", point.y},   {"z", point.z},
                                              {"before", before},     {"after", after}, {"found", found},
                                              {"force", load.force.z}};
  demand(broken, std::isfinite(found) && std::isfinite(after), "a drive must stay finite", at);
  demand(broken, std::abs(found - after) <= granted, "a step must move the surface at the velocity that the drive says",
         at);
  const double fastest = std::max(boundary::approach_speed(drive), boundary::approach_speed(moved));
  demand(broken, -found <= fastest + granted && -before <= fastest * (1 + 1e-9) + 1e-12,
         "no surface may come nearer to a grain faster than the approach speed", at);
}

/// The velocity of a point is the same in double and in lanes.
template <class D>
void demand_velocity_in_lanes(report& broken, const D& drive, const std::vector<sphere<double>>& samples) {
  if constexpr (!boundary::HasOneVelocity<D>) {
    const auto of = [&]<class U>(const sphere<U>& s) {
      const Vec3<U> v = drive.velocity_at(s.centre);
      return U(v.x + U(2) * v.y + U(4) * v.z);
    };
    demand_same_in<block>(broken, "the velocity of a point must be the same in lanes", samples, of, 1e-11,
                          [&](const auto& s) { return 1e-11 * norm(drive.velocity_at(s.centre)); });
  }
}
}  // namespace detail

/// What a drive promises beyond its signature, with the shape that it moves and the grains in a room (m), which must be
/// within the reach of the drive. `time_step` is one in which it moves by little, s.
template <class D, boundary::Geometry G>
  requires boundary::Drive<D, G> report drive_report(const D& drive, const G& shape, const box& room,
                                                     double time_step = 1e-7) {
    report broken;
    const std::vector<sphere<double>> samples = sphere_samples(room);
    for (const sphere<double>& s : samples) {
      for (const double push : {0.0, 1e-3, -1e-3}) {
        const boundary::wall_load load{{0, 0, push}, {0, 0, push * norm(room.upper - room.lower)}, 0};
        detail::demand_motion(broken, drive, shape, load, s, time_step);
      }
    }
    detail::demand_velocity_in_lanes(broken, drive, samples);
    return broken;
  }

}  // namespace pendular::testing
