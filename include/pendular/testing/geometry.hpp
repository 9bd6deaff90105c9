// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/concepts.hpp>
#include <pendular/boundary/turn.hpp>
#include <pendular/core/lanes.hpp>
#include <pendular/space/cell_grid.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/scalars.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace pendular::testing {

/// A grain near a wall.
template <class T>
struct sphere {
  Vec3<T> centre;  // m
  T radius;        // m
};

template <class T>
sphere<T> gathered(const std::vector<sphere<double>>& samples, std::size_t first) {
  const auto of = [&](auto member) {
    return gathered<T>(first, [&](std::size_t k) { return member(samples[k % samples.size()]); });
  };
  return {{of([](const auto& s) { return s.centre.x; }), of([](const auto& s) { return s.centre.y; }),
           of([](const auto& s) { return s.centre.z; })},
          of([](const auto& s) { return s.radius; })};
}

/// Spread over a box by the golden ratio's relatives in three dimensions, of some hundredths of its size.
inline std::vector<sphere<double>> sphere_samples(const box& room, std::size_t count = 240) {
  const vector size = room.upper - room.lower;
  const double shortest = std::min({size.x, size.y, size.z});
  const auto share = [](double step, std::size_t k) {
    const double x = step * static_cast<double>(k + 1);
    return x - std::floor(x);
  };
  std::vector<sphere<double>> samples;
  for (std::size_t k = 0; k < count; ++k) {
    const vector at{share(0.8191725134, k) * size.x, share(0.6710436067, k) * size.y, share(0.5497004779, k) * size.z};
    samples.push_back({room.lower + at, shortest * (k % 2 == 0 ? 0.02 : 0.05)});
  }
  return samples;
}

namespace detail {
/// Slope of the gap along a direction, with a way that is short against the room.
template <class G>
double gap_slope(const G& shape, const sphere<double>& s, const vector& along, double way) {
  const double ahead = shape.meet(vector(s.centre + way * along), s.radius).gap;
  const double behind = shape.meet(vector(s.centre - way * along), s.radius).gap;
  return (ahead - behind) / (2 * way);
}

/// Away from kinks, which two steps of different length do not both straddle.
template <class G>
bool slopes_with_normal(const G& shape, const sphere<double>& s, const vector& along, double size) {
  const double expected = -dot(shape.meet(s.centre, s.radius).normal, along);
  for (const double way : {1e-5, 1e-7}) {
    if (std::abs(gap_slope(shape, s, along, way * size) - expected) < 1e-3) return true;
  }
  return false;
}

template <class G>
void demand_meeting(report& broken, const G& shape, const sphere<double>& s, double size) {
  const boundary::meeting<double> m = shape.meet(s.centre, s.radius);
  const double length = norm(m.normal);
  const std::initializer_list<quantity> at = {
      {"x", s.centre.x}, {"y", s.centre.y}, {"z", s.centre.z}, {"radius", s.radius}, {"gap", m.gap}};
  demand(broken, std::isfinite(m.gap) && std::isfinite(length), "gap and normal must be finite", at);
  demand(broken, std::abs(length - 1) < 1e-9, "the normal must be a unit vector", at);
  const boundary::meeting<double> wider = shape.meet(s.centre, 2 * s.radius);
  demand(broken, std::abs(m.gap - s.radius - wider.gap) <= 1e-9 * size && norm(m.normal - wider.normal) <= 1e-9,
         "a wider sphere must be nearer by its radius, along the same normal", at);
  for (const vector& along : {vector{1, 0, 0}, vector{0, 1, 0}, vector{0, 0, 1}}) {
    demand(broken, slopes_with_normal(shape, s, along, size),
           "the gap must shrink by the way that a sphere goes along the normal, and not change across it", at);
  }
}

/// A shape that the library can turn meets a sphere that is turned with it as before.
template <class G>
void demand_turning(report& broken, const G& shape, const sphere<double>& s, double size) {
  if constexpr (
      requires(const G g) { g.point, g.direction; } || requires(const G g) { g.point, g.normal; }) {
    const vector centre = size * vector{0.3, -0.2, 0.1}, axis{0.48, 0.6, 0.64}, shift = size * vector{2, -1, 3};
    G turned_shape = shape;
    boundary::turn(turned_shape, centre, axis, 0.7);
    turned_shape.point += shift;
    const vector moved = centre + boundary::turned(s.centre - centre, axis, 0.7) + shift;
    const double before = shape.meet(s.centre, s.radius).gap, after = turned_shape.meet(moved, s.radius).gap;
    demand(broken, std::abs(before - after) <= 1e-9 * size, "a shape must meet spheres alike wherever it stands",
           {{"gap", before}, {"turned and moved", after}});
  }
}

template <class T, class G>
concept MeetsIn = requires(const G shape, const Vec3<T> centre, const T radius) {
  { shape.meet(centre, radius) } -> std::convertible_to<boundary::meeting<T>>;
};

template <class T, class G>
void demand_geometry_in(report& broken, const G& shape, const std::vector<sphere<double>>& samples, double size,
                        std::string_view property) {
  demand(broken, MeetsIn<T, G>, property, {});
  if constexpr (MeetsIn<T, G>) {
    const auto of = [&]<class U>(const sphere<U>& s) {
      const boundary::meeting<U> m = shape.meet(s.centre, s.radius);
      return U(U(1 / size) * m.gap + m.normal.x + U(2) * m.normal.y + U(4) * m.normal.z);
    };
    const double rounding = std::is_same_v<element_t<T>, float> ? 1e-4 : 1e-11;
    demand_same_in<T>(broken, property, samples, of, granted_error<T>, [&](const auto&) { return rounding; });
  }
}
}  // namespace detail

/// What the shape of a wall promises beyond its signature, for grains in a room (m).
template <boundary::Geometry G>
report geometry_report(const G& shape, const box& room) {
  report broken;
  const std::vector<sphere<double>> samples = sphere_samples(room);
  const double size = norm(room.upper - room.lower);
  for (const sphere<double>& s : samples) {
    detail::demand_meeting(broken, shape, s, size);
    detail::demand_turning(broken, shape, s, size);
  }
  detail::demand_geometry_in<float>(broken, shape, samples, size, "gap and normal must be the same in float");
  detail::demand_geometry_in<lanes<8>>(broken, shape, samples, size,
                                       "gap and normal must be the same in lanes of double");
  detail::demand_geometry_in<lanes<16, float>>(broken, shape, samples, size,
                                               "gap and normal must be the same in lanes of float");
  return broken;
}

}  // namespace pendular::testing
