// SPDX-License-Identifier: BSD-3-Clause
// A friction law and a damping law of a user, both of which remember something per contact, in one system: numbers worked
// out by hand, through new neighbour lists, a resume and on threads.
#include "../catch.hpp"
#include "resumed.hpp"

#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pendular;

namespace {

/// Friction that wears off with the way that its contact has slid.
struct wearing_friction {
  double coefficient;  // mu of a fresh contact
  double length;       // m, over which it falls to 1/e

  template <class T>
  struct contact_memory {
    T way;  // m
  };

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force, contact_memory<T>& memory) const {
    memory.way = unit_step(normal_force) * (memory.way + T(s.time_step) * norm(s.velocity));
    const T limit = T(coefficient) * pendular::exp(T(memory.way * T(-1 / length))) * normal_force;
    return shortened_to(Vec3<T>(T(-1 / s.time_step) * s.tangential_mass * s.velocity), limit);
  }
};

/// A dashpot set by the speed at which its contact closed first.
struct entry_dashpot {
  double per_speed;  // N s2/m2

  template <class T>
  struct contact_memory {
    T entry;  // m/s
  };

  template <Scalar T>
  T resistance(const approach<T>& a, const T&, contact_memory<T>& memory) const {
    const T touching = unit_step(T(-a.gap));
    memory.entry = touching * pendular::select(memory.entry > T(0), memory.entry, a.closing_speed);
    return touching * T(per_speed) * memory.entry * a.closing_speed;
  }
};
static_assert(check::friction_law<wearing_friction> && check::damping_law<entry_dashpot>);

constexpr double r = 0.5e-3, rho = 2600, g = 9.81, k_n = 1e3, mu = 0.4, worn = 1e-3, per_speed = 0.02;
constexpr double mass = 4.0 / 3 * std::numbers::pi * r * r * r * rho;
constexpr double slide_speed = 0.5, hit_speed = 0.3;

auto empty_scene() {
  return pendular::system{material{wearing_friction{mu, worn}, normal::linear{k_n}, entry_dashpot{per_speed}},
                          boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                          velocity_verlet{1e-6, {0, 0, -g}}};
}
using scene = decltype(empty_scene());

/// Grain 0 slides over the floor, at rest along its normal; grain 1 hits grain 2, of twice its radius, in free fall.
scene slide_and_hit() {
  scene s = empty_scene();
  s.add({{0, 0, r - mass * g / k_n}, r, rho, {slide_speed, 0, 0}});
  s.add({{0, 0, 30e-3}, r, rho, {hit_speed, 0, 0}});
  s.add({{3 * r + 10e-6, 0, 30e-3}, 2 * r, rho, {0, 0, 0}});
  return s;
}
constexpr int until_hit = 34, in_the_hit = 60, after_the_hit = 400;  // steps; the hit lasts about 115

vector velocity(const scene& s, std::int64_t id) {
  return s.particles().get<column::velocity>()[s.particles().row_of(id)];
}

/// A linear dashpot c beside a spring gives back exp(-pi z / sqrt(1 - z^2)) of the speed, z = c / (2 sqrt(m k)) (Schaefer,
/// Dippel, Wolf 1996), here with c in proportion to the speed.
void check_hit(const scene& s) {
  const double reduced = mass * 8 / 9;
  const double z = per_speed * hit_speed / (2 * std::sqrt(reduced * k_n));
  const double restitution = std::exp(-std::numbers::pi * z / std::sqrt(1 - z * z));
  CHECK((velocity(s, 2).x - velocity(s, 1).x) / hit_speed == within(2e-3, restitution));
}
/// The slip u of a solid sphere changes by 7/2 of its deceleration, u du/dw = -7/2 mu g exp(-w / l) over the way w: it
/// never stops if u^2 > 7 mu g l, and 2/7 of what it lost the centre has lost.
void check_slide(const scene& s) {
  const double slip = std::sqrt(slide_speed * slide_speed - 7 * mu * g * worn);
  CHECK(velocity(s, 0).x == within(1e-4, slide_speed - 2.0 / 7 * (slide_speed - slip)));
  const double spin = s.particles().get<column::angular_velocity>()[s.particles().row_of(0)].y;
  CHECK(velocity(s, 0).x - r * spin == within(1e-3, slip));
}

std::vector<vector> velocities(const scene& s) {
  std::vector<vector> all;
  for (const std::size_t row : s.particles().rows_by_id()) {
    all.push_back(s.particles().get<column::velocity>()[row]);
    all.push_back(s.particles().get<column::angular_velocity>()[row]);
  }
  return all;
}

}  // namespace

TEST_CASE("two laws of one's own that remember give the numbers worked out by hand") {
  scene s = slide_and_hit();
  s.run(after_the_hit);
  check_hit(s);
  s.run(20000);  // ten times the length over which friction wears off, many lists
  CHECK(s.rebuild_count() > 10);
  check_slide(s);
}

TEST_CASE("both memories of one contact work at once: an oblique hit on the floor") {
  scene s = empty_scene();
  s.add({{0, 0, r + 1e-9}, r, rho, {0.8, 0, -0.05}});
  s.run(120);  // it has just left
  const vector v = velocity(s, 0);
  REQUIRE(s.particles().get<column::position>()[0].z > r);
  const double z = per_speed * 0.05 / (2 * std::sqrt(mass * k_n));
  CHECK(v.z / 0.05 == within(3e-3, std::exp(-std::numbers::pi * z / std::sqrt(1 - z * z))));
  // It slides all the while: mu times the momentum of the normal, worn by a way of 0.8 m/s times the time from then on,
  // symmetric about half of the contact's duration pi sqrt(m/k).
  const double way = 0.8 * 0.5 * std::numbers::pi * std::sqrt(mass / k_n);
  CHECK(0.8 - v.x == within(2e-2, mu * std::exp(-way / worn) * (v.z + 0.05)));
}

TEST_CASE("both memories stay with their contacts in a new list, in a hit and in a slide") {
  scene s = slide_and_hit();
  s.run(until_hit + in_the_hit);
  REQUIRE(s.contacts().gap()[0] < 0);
  s.canonicalise();
  s.add({{5e-3, 5e-3, 10e-3}, r, rho});
  s.run(after_the_hit);
  check_hit(s);
  for (int part = 0; part < 10; ++part) {
    s.run(2000);
    s.canonicalise();
  }
  check_slide(s);
}

TEST_CASE("both memories are in a checkpoint: the resumed scene has the same bits and the same numbers") {
  scene s = slide_and_hit();
  s.run(until_hit + in_the_hit);
  scene again = resumed(s, empty_scene());
  for (scene* each : {&s, &again}) each->run(after_the_hit);
  CHECK(velocities(again) == velocities(s));
  check_hit(again);
  again = resumed(s, empty_scene());
  again.run(20000);
  check_slide(again);
}

TEST_CASE("what two laws remember does not depend on the number of threads") {
  const auto shaken = [] {
    scene s = empty_scene();
    for (int k = 0; k < 1000; ++k) {
      const double x = k % 10, y = k / 10 % 10, z = k / 100;
      s.add({{1.001e-3 * x, 1.001e-3 * y, 0.6e-3 + 1.001e-3 * z},
             r,
             rho,
             {0.1 * std::sin(7.0 * k), 0.1 * std::sin(11.0 * k), 0.1 * std::sin(13.0 * k)}});
    }
    s.run(1500);
    return velocities(s);
  };
#ifdef _OPENMP
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = shaken();
  omp_set_num_threads(2);
  CHECK(shaken() == one);
  omp_set_num_threads(before);
#else
  CHECK(shaken() == shaken());
#endif
}
