// SPDX-License-Identifier: BSD-3-Clause
// Shapes, drives, walls and boundaries keep their promises, and the kits find one that does not.
#include "../found.hpp"

#include <pendular/boundary/rimmed_cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/turning.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/testing/boundary.hpp>
#include <pendular/testing/role_archetypes.hpp>

#include <cmath>
#include <tuple>

using namespace pendular;
using namespace pendular::boundary;
using testing::boundary_report;
using testing::drive_report;
using testing::geometry_report;
namespace archetype = pendular::testing::archetype;

namespace {
const box room{{-5e-3, -5e-3, -5e-3}, {5e-3, 5e-3, 5e-3}};
const vector oblique{0.48, 0.6, 0.64};

/// A floor with one mistake.
struct bad_floor {
  enum class mistake { none, long_normal, into_the_room, doubled_gap, of_the_diameter, rough_in_float, sunk_in_lanes };
  mistake made;
  template <Scalar T>
  meeting<T> meet(const Vec3<T>& centre, const T& radius) const {
    using enum mistake;
    const T height = centre.z + T(6e-3);
    meeting<T> m{height - radius, {T(0), T(0), T(-1)}};
    if (made == long_normal) m.normal.z = T(-2);
    if (made == into_the_room) m.normal.z = T(1);
    if (made == doubled_gap) m.gap = T(2) * height - radius;
    if (made == of_the_diameter) m.gap = height - T(2) * radius;
    if constexpr (std::is_same_v<T, float>) {
      if (made == rough_in_float) m.gap = m.gap + T(1e-3);
    }
    if constexpr (pendular::detail::Lanes<T>) {
      if (made == sunk_in_lanes) m.gap.set(1, m.gap[0]);
    }
    return m;
  }
};
/// Stands at the origin whatever its point says.
struct rooted : plane {
  template <Scalar T>
  meeting<T> meet(const Vec3<T>& centre, const T& radius) const {
    return plane{{0, 0, 0}, normal}.meet(centre, radius);
  }
};

/// A lift with one mistake.
struct bad_lift {
  enum class mistake { none, slips, creeps };
  mistake made;
  vector velocity{0, 0, 0.3};
  void move(plane& floor, const vector&, double time_step) {
    floor.point += (made == mistake::slips ? 0.5 : 1.0) * time_step * velocity;
    if (made == mistake::creeps) floor.point += time_step * vector{0, 0, 0.01};
  }
};
/// A blade on an axis with one mistake.
struct bad_blade {
  enum class mistake { none, backwards, slow, in_double };
  mistake made;
  double rate = 5;
  template <Scalar T>
  Vec3<T> velocity_at(const Vec3<T>& p) const {
    double now = made == mistake::backwards ? -rate : rate;
    if (pendular::detail::Lanes<T> && made == mistake::in_double) now *= 2;
    return {T(-now) * p.y, T(now) * p.x, T(0)};
  }
  vector pivot() const { return {0, 0, 0}; }
  double approach_speed() const { return (made == mistake::slow ? 0.1 : 1.0) * rate * 9e-3; }
  void move(plane& blade, const wall_load&, double time_step) { turn(blade, {0, 0, 0}, {0, 0, 1}, rate * time_step); }
};

/// A wall with one mistake.
struct bad_wall : wall<plane, constant_velocity> {
  enum class mistake { none, forgets, idle, standing, stays };
  mistake made;
  explicit bad_wall(mistake m) : wall(plane{{0, 0, 0}, {0, 0, 1}}, constant_velocity{{0, 0, 0.3}}), made(m) {}
  void take(const wall_load& now, double time_step) {
    if (made == mistake::forgets) return;
    if (made == mistake::standing) work += 1;
    if (made != mistake::idle) return wall::take(now, time_step);
    force = now.force;
  }
  void move(double time_step) {
    if (made != mistake::stays) wall::move(time_step);
  }
};
struct one_wall {
  bad_wall only;
  auto parts() { return std::tie(only); }
  auto parts() const { return std::tie(only); }
};

/// Keeps references to the walls of the boundary it was copied from.
struct stale {
  wall<plane> floor{plane{{0, 0, -6e-3}, {0, 0, 1}}};
  std::tuple<wall<plane>&> kept{floor};
  stale() = default;
  stale(const stale& other) = default;
  stale& operator=(const stale& other) {
    floor = other.floor;
    return *this;
  }
  auto parts() { return kept; }
  auto parts() const { return std::tuple<const wall<plane>&>(std::get<0>(kept)); }
};
}  // namespace

TEST_CASE("shipped shapes and the archetype keep their promises") {
  check_sound(geometry_report(plane{{1e-3, 2e-3, -3e-3}, oblique}, room));
  check_sound(geometry_report(cylinder{{1e-3, 0, 0}, oblique, 12e-3}, room));
  check_sound(geometry_report(rimmed_cylinder{{0, 1e-3, 0}, oblique, 6e-3}, room));
  check_sound(geometry_report(archetype::geometry(-6e-3), room));
}

TEST_CASE("the kit of shapes finds a broken promise") {
  using enum bad_floor::mistake;
  const auto of = [](auto made) { return geometry_report(bad_floor{made}, room); };
  check_sound(of(none));
  CHECK(finds(of(long_normal), "the normal must be a unit vector"));
  CHECK(finds(of(into_the_room), "the gap must shrink by the way"));
  CHECK(finds(of(doubled_gap), "the gap must shrink by the way"));
  CHECK(finds(of(of_the_diameter), "a wider sphere must be nearer by its radius"));
  CHECK(finds(of(rough_in_float), "gap and normal must be the same in float"));
  CHECK(finds(of(sunk_in_lanes), "gap and normal must be the same in lanes of double"));
  CHECK(finds(geometry_report(rooted{{{0, 0, 0}, oblique}}, room), "a shape must meet spheres alike wherever"));
}

TEST_CASE("shipped drives and archetypes keep their promises") {
  const plane floor{{0, 0, -6e-3}, {0, 0, 1}}, blade{{0, 0, 0}, {0, 1, 0}};
  check_sound(drive_report(fixed{}, floor, room));
  check_sound(drive_report(constant_velocity{{0.1, -0.2, 0.3}}, floor, room));
  check_sound(drive_report(constant_velocity{{0.1, -0.2, 0.3}}, cylinder{{0, 0, 0}, oblique, 12e-3}, room));
  check_sound(drive_report(turning{{0, 0, 0}, {0, 0, 1}, 5, 9e-3}, blade, room));
  check_sound(drive_report(turning{{1e-3, 0, 0}, oblique, -5}, cylinder{{1e-3, 0, 0}, oblique, 12e-3}, room));
  check_sound(drive_report(turning{{1e-3, 0, 0}, {0, 1, 0}, 5, 20e-3}, cylinder{{0, 0, 0}, oblique, 12e-3}, room));
  check_sound(drive_report(servo_stress{300, 1e-4, 1e-4, 0.2, {0, 0, 0.1}, {0.2, 0, 0}}, floor, room));
  check_sound(drive_report(archetype::drive(0.2), archetype::geometry(-6e-3), room));
  check_sound(drive_report(archetype::drive_of_points(3), archetype::geometry(-6e-3), room));
}

TEST_CASE("the kit of drives finds a broken promise") {
  const plane floor{{0, 0, -6e-3}, {0, 0, 1}}, blade{{0, 0, 0}, {0, 1, 0}};
  const auto lift = [&](auto made) { return drive_report(bad_lift{made}, floor, room); };
  check_sound(lift(bad_lift::mistake::none));
  CHECK(finds(lift(bad_lift::mistake::slips), "a step must move the surface at the velocity"));
  CHECK(finds(lift(bad_lift::mistake::creeps), "no surface may come nearer to a grain faster"));
  const auto turn = [&](auto made) { return drive_report(bad_blade{made}, blade, room); };
  check_sound(turn(bad_blade::mistake::none));
  CHECK(finds(turn(bad_blade::mistake::backwards), "a step must move the surface at the velocity"));
  CHECK(finds(turn(bad_blade::mistake::slow), "no surface may come nearer to a grain faster"));
  CHECK(finds(turn(bad_blade::mistake::in_double), "the velocity of a point must be the same in lanes"));
}

TEST_CASE("boundaries and walls keep their promises") {
  const plane floor{{0, 0, -6e-3}, {0, 0, 1}}, lid{{0, 0, 6e-3}, {0, 0, -1}};
  check_sound(boundary_report(walls{}, room));
  check_sound(boundary_report(walls{wall{floor}, wall{lid, servo_stress{300, 1e-4, 1e-4, 0.2, {0, 0, 0.1}}},
                                    wall{cylinder{{0, 0, 0}, {0, 0, 1}, 9e-3}, turning{{0, 0, 0}, {0, 0, 1}, 5}}},
                              room));
  check_sound(boundary_report(archetype::boundary_of_two(-6e-3), room));
}

TEST_CASE("the kit of boundaries finds a broken promise") {
  using enum bad_wall::mistake;
  const auto of = [](auto made) { return boundary_report(one_wall{bad_wall(made)}, room); };
  check_sound(of(none));
  CHECK(finds(of(forgets), "a wall must have the force that it was told"));
  CHECK(finds(of(idle), "the work of a wall must be its power times the time step"));
  CHECK(finds(of(standing), "a wall does no work while the scene stands"));
  CHECK(finds(of(stays), "a wall must move as its drive moves it"));
  CHECK(finds(boundary_report(stale{}, room), "a copy of a boundary must answer parts of its own"));
  CHECK(finds(boundary_report(walls{wall{bad_floor{bad_floor::mistake::long_normal}}}, room),
              "the normal must be a unit vector"));
}
