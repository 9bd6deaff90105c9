// SPDX-License-Identifier: BSD-3-Clause

// Head-on impacts through the whole system against closed forms: restitution of the linear spring with three dampings
// (physics 4.2), the falling sphere and the stacked spheres of the MFiX-DEM verification suite, Hertz impacts of
// Chung and Ooi 2011.
#include "scenes.hpp"

#include <pendular/law/damping/clamped.hpp>

#include <algorithm>
#include <array>
#include <functional>

using namespace pendular;
using namespace scenes;

namespace {

constexpr double radius = 0.5e-3, density = 2600, stiffness_n = 1e3, speed = 0.1;
constexpr int phases = 64;

struct restitutions {
  double mean, worst;  // mean over the phases, largest distance from the exact value
  double momentum;     // relative drift of the sum
};

/// 64 impacts that differ in where inside a step the surfaces meet, side by side in one scene.
template <class Integration, class Damping>
restitutions pair_impacts(const Damping& damping, double steps_per_contact, double exact) {
  const double mass = sphere_mass(radius, density);
  const double dt = pi * std::sqrt(0.5 * mass / stiffness_n) / steps_per_contact;
  pendular::system s{material{normal::linear{stiffness_n}, damping}, boundary::walls{}, Integration{dt},
                     run_options{.force = true}};
  for (int k = 0; k < phases; ++k) {
    const double gap = (3.0 + (k + 0.5) / phases) * speed * dt;
    const double y = 4e-3 * k;
    s.add({{0, y, 0}, radius, density, {0.75 * speed, 0, 0}});
    s.add({{2 * radius + gap, y, 0}, radius, density, {-0.25 * speed, 0, 0}});
  }
  s.run(static_cast<std::int64_t>(3 * steps_per_contact) + 10);
  restitutions r{0, 0, 0};
  for (int k = 0; k < phases; ++k) {
    const double a = velocity(s, 2 * k).x, b = velocity(s, 2 * k + 1).x;
    REQUIRE(gap_of(s, 2 * k, 2 * k + 1) > 0);
    const double e = (b - a) / speed;
    r.mean += e / phases;
    r.worst = std::max(r.worst, std::abs(e - exact));
    r.momentum = std::max(r.momentum, std::abs((a + b) / (0.5 * speed) - 1));
  }
  return r;
}

template <class Integration, class Damping>
restitutions wall_impacts(const Damping& damping, double steps_per_contact, double exact) {
  const double dt = pi * std::sqrt(sphere_mass(radius, density) / stiffness_n) / steps_per_contact;
  pendular::system s{material{normal::linear{stiffness_n}, damping}, floor_plane(), Integration{dt},
                     run_options{.force = true}};
  for (int k = 0; k < phases; ++k) {
    s.add({{2e-3 * k, 0, radius + (3.0 + (k + 0.5) / phases) * speed * dt}, radius, density, {0, 0, -speed}});
  }
  s.run(static_cast<std::int64_t>(3 * steps_per_contact) + 10);
  restitutions r{0, 0, 0};
  for (int k = 0; k < phases; ++k) {
    REQUIRE(position(s, k).z > radius);
    const double e = velocity(s, k).z / speed;
    r.mean += e / phases;
    r.worst = std::max(r.worst, std::abs(e - exact));
  }
  return r;
}

struct row {
  double rate, approach_only, two_sided, clamped;
};
constexpr std::array<row, 4> table{{{.05, .92669, .85447, .85876},  // physics 4.2, checked there against an ODE solver
                                    {.2, .75613, .52662, .57174},
                                    {.5, .54629, .16303, .29844},
                                    {.8, .42401, .01516, .17978}}};

template <class Damping>
void check_restitution(const Damping& damping, double rate, double exact) {
  const auto pair = pair_impacts<velocity_verlet>(damping, 200, exact);
  const auto wall = wall_impacts<velocity_verlet>(damping, 200, exact);
  CAPTURE(rate, exact, pair.mean, pair.worst, wall.mean, wall.worst);
  CHECK(pair.mean == near(1e-3, exact));
  CHECK(wall.mean == near(1e-3, exact));
  CHECK(pair.mean == near(2e-4, exact));
  CHECK(pair.momentum < 1e-13);
  // The dashpot switches on with 2 alpha omega v0, and off with e times that if it is two-sided. Half a step too early or
  // too late changes the speed by alpha omega dt v0 = alpha pi / 200 of v0 at entry, which the impact passes on e-fold,
  // and by e times as much at the exit.
  const double first_order = 2 * exact * rate * pi / 200;
  CHECK(pair.worst < first_order + 1e-4);
  CHECK(wall.worst < first_order + 1e-4);
  CHECK(pair.worst > 0.2 * first_order);  // else the phases did not vary
}

}  // namespace

TEST_CASE("restitution of three dampings is that of the closed form, for pairs and walls") {
  for (const row& r : table) {
    check_restitution(damping::viscous_on_approach{r.rate}, r.rate, r.approach_only);
    check_restitution(damping::viscous{r.rate}, r.rate, r.two_sided);
    check_restitution(damping::clamped{damping::viscous{r.rate}}, r.rate, r.clamped);
  }
}

// Forces as they act, looked at in every step; the two-sided dashpot pulls while grains part.
TEST_CASE("under a clamped dashpot no dry contact attracts, of unequal grains or at a wall, linear or Hertz") {
  const auto least_force = [](const auto& spring, const auto& damping, double time_step) {
    pendular::system s{material{spring, damping}, floor_plane(), velocity_verlet{time_step},
                       run_options{.force = true}};
    s.add({{0, 0, radius + 1e-9}, radius, density, {0, 0, -speed}});
    s.add({{10e-3, 0, 5e-3}, radius, density, {speed, 0, 0}});
    s.add({{10e-3 + 2.5 * radius + 1e-9, 0, 5e-3}, 1.5 * radius, density, {-0.5 * speed, 0, 0}});
    double pair = 0, wall = 0;
    for (int step = 0; step < 4000; ++step) {
      s.run(1);
      if (s.view().pairs > 0) pair = std::min(pair, -s.contacts().force(0).x);
      s.for_each_wall([&](const auto&, const auto& contacts) {
        if (contacts.size() > 0) wall = std::min(wall, contacts.force(0).z);
      });
    }
    REQUIRE(position(s, 0).z > radius);
    REQUIRE(gap_of(s, 1, 2) > 0);
    return std::array{pair, wall};
  };
  for (const double rate : {0.3, 0.8}) {
    const damping::viscous two_sided{rate};
    const normal::linear linear{stiffness_n};
    const normal::hertz hertz{1e7, 0.25};
    CHECK(least_force(linear, damping::clamped{two_sided}, 2e-7) == std::array{0.0, 0.0});
    CHECK(least_force(hertz, damping::clamped{two_sided}, 2e-7) == std::array{0.0, 0.0});
    const auto pulls = least_force(linear, two_sided, 2e-7), pulls_too = least_force(hertz, two_sided, 2e-7);
    CHECK((pulls[0] < -1e-6 && pulls[1] < -1e-6 && pulls_too[0] < -1e-6 && pulls_too[1] < -1e-6));
  }
}

TEST_CASE("mean restitution converges at second order with synchronised velocities and at first with half-step ones") {
  const double rate = 0.3;  // two-sided, e = exp(-pi a / sqrt(1 - a^2))
  const double exact = std::exp(-pi * rate / std::sqrt(1 - rate * rate));
  std::array<double, 3> synchronised{}, half_step{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double steps = 25.0 * std::pow(2.0, static_cast<double>(k));
    synchronised[k] = std::abs(pair_impacts<velocity_verlet>(damping::viscous{rate}, steps, exact).mean - exact);
    half_step[k] = std::abs(pair_impacts<half_step_velocity_verlet>(damping::viscous{rate}, steps, exact).mean - exact);
  }
  CAPTURE(synchronised, half_step);
  CHECK(synchronised[0] / synchronised[1] == near(1.2, 4.0));
  CHECK(synchronised[1] / synchronised[2] == near(1.2, 4.0));
  CHECK(half_step[0] / half_step[1] == near(0.4, 2.0));
  CHECK(half_step[1] / half_step[2] == near(0.4, 2.0));
}

TEST_CASE("an undamped impact gives back all its speed after half a period") {
  const auto r = pair_impacts<velocity_verlet>(damping::viscous{0}, 50, 1.0);
  CHECK(r.worst < 1e-4);
  CHECK(r.momentum < 1e-13);
}

TEST_CASE("DEM01: a sphere falls, dips into the floor and leaves it as the closed form says") {
  // MFiX-DEM verification DEM01: D = 0.2 m, 2600 kg/m3, centre at 0.5 m, g = 9.80665 m/s2.
  const double r = 0.1, rho = 2600, g = 9.80665, h = 0.5, mass = sphere_mass(r, rho);
  CHECK(mass == within(1e-4, 10.891));
  const double impact_time = std::sqrt(2 * (h - r) / g), impact_speed = std::sqrt(2 * g * (h - r));
  CHECK(impact_time == within(2e-5, 0.28562));
  CHECK(impact_speed == within(1e-5, 2.80095));
  for (const double k : {1e4, 2.5e4, 5e4, 1e5}) {
    for (const double e : {0.6, 0.8, 0.9, 1.0}) {
      const double b = e < 1 ? damping_rate_for(e) : 0.0;
      if (k == 1e4 && e == 0.9) CHECK(b == within(2e-5, 0.033518));
      if (k == 1e4 && e > 0.85) continue;  // the centre would go through the floor, and the overlap limit stops that
      const double omega = std::sqrt(k / mass), damped = omega * std::sqrt(1 - b * b);
      const double dt = pi / omega / 1000;
      pendular::system s{material{normal::linear{k}, damping::viscous{b}}, floor_plane(),
                         velocity_verlet{dt, {0, 0, -g}}, run_options{.overlap_limit = 0.99, .force = true}};
      s.add({{0, 0, h}, r, rho});
      const auto exact = [&](double t) {
        if (t < impact_time) return h - 0.5 * g * t * t;
        const double u = t - impact_time;
        return (g / (omega * omega) * std::cos(damped * u) +
                (b * g / omega - impact_speed) / damped * std::sin(damped * u)) *
                   std::exp(-b * omega * u) +
               r - g / (omega * omega);
      };
      double worst = 0;
      while (s.time() < impact_time + 0.95 * pi / damped) {
        s.run(1);
        worst = std::max(worst, std::abs(position(s, 0).z - exact(s.time())));
      }
      CAPTURE(k, e, worst * omega / impact_speed);
      CHECK(worst < 1e-3 * impact_speed / omega);
    }
  }
}

TEST_CASE("DEM02: bounce heights go to those of a hard sphere as the floor stiffens") {
  const double r = 0.1, rho = 2600, g = 9.80665, h = 0.5, e = 0.8, mass = sphere_mass(r, rho);
  double last = 1;
  for (const double k : {5e4, 5e5, 5e6}) {
    const double dt = pi * std::sqrt(mass / k) / 200;
    pendular::system s{material{normal::linear{k}, damping::viscous{damping_rate_for(e)}}, floor_plane(),
                       velocity_verlet{dt, {0, 0, -g}}, run_options{.overlap_limit = 0.99, .force = true}};
    s.add({{0, 0, h}, r, rho});
    double deviation = 0, before = 0;
    for (int bounce = 1; bounce <= 3;) {
      s.run(1);
      const double now = velocity(s, 0).z;
      if (before > 0 && now <= 0) {
        deviation = std::max(deviation, std::abs(position(s, 0).z - r - (h - r) * std::pow(e, 2 * bounce)) / (h - r));
        ++bounce;
      }
      before = now;
    }
    CAPTURE(k, deviation);
    CHECK(deviation < last / 2.5);  // the shift is about the static sag over the dip, 1/sqrt(k)
    last = deviation;
  }
  CHECK(last < 5e-3);
}

TEST_CASE("DEM03: two spheres squeezed between two walls move as the linear equations say") {
  // MFiX-DEM verification DEM03: D = 1 mm, 20000 and 10000 kg/m3, walls at 0 and 1.8 mm, k = 1000 N/m.
  const double r = 0.5e-3, k = 1e3, g = 9.81, top = 1.8e-3;
  const double m1 = sphere_mass(r, 2e4), m2 = sphere_mass(r, 1e4), m12 = m1 * m2 / (m1 + m2);
  for (const double e : {0.5, 0.7, 0.9, 1.0}) {
    const double rate = e < 1 ? damping_rate_for(e) : 0;
    const auto acceleration = [&](const std::array<double, 4>& y) {  // heights and velocities of both
      const auto push = [&](double gap, double closing, double mass) {
        return gap < 0 ? -k * gap + 2 * rate * std::sqrt(mass * k) * closing : 0.0;
      };
      const double low = push(y[0] - r, -y[2], m1), high = push(top - y[1] - r, y[3], m2);
      const double middle = push(y[1] - y[0] - 2 * r, y[2] - y[3], m12);
      return std::array<double, 4>{y[2], y[3], (low - middle) / m1 - g, (middle - high) / m2 - g};
    };
    const double dt = pi * std::sqrt(m12 / k) / 400;
    pendular::system s{material{normal::linear{k}, damping::viscous{rate}},
                       boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                                       boundary::wall{boundary::plane{{0, 0, top}, {0, 0, -1}}}},
                       velocity_verlet{dt, {0, 0, -g}}, run_options{.overlap_limit = 0.5, .force = true}};
    s.add({{0, 0, 0.45e-3}, r, 2e4});
    s.add({{0, 0, 1.35e-3}, r, 1e4});
    std::array<double, 4> y{0.45e-3, 1.35e-3, 0, 0};
    double worst = 0;
    for (int step = 0; step < 4000; ++step) {
      s.run(1);
      for (int sub = 0; sub < 4; ++sub) {  // classical Runge-Kutta of order four
        const double step_length = dt / 4;
        const auto moved = [&](const std::array<double, 4>& rate_of, double by) {
          std::array<double, 4> z = y;
          for (std::size_t c = 0; c < 4; ++c) z[c] += by * rate_of[c];
          return z;
        };
        const auto k1 = acceleration(y), k2 = acceleration(moved(k1, step_length / 2)),
                   k3 = acceleration(moved(k2, step_length / 2)), k4 = acceleration(moved(k3, step_length));
        for (std::size_t c = 0; c < 4; ++c) y[c] += step_length / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]);
      }
      worst = std::max({worst, std::abs(position(s, 0).z - y[0]), std::abs(position(s, 1).z - y[1])});
    }
    CAPTURE(e, worst);
    CHECK(worst < 2e-3 * 0.0167e-3);  // of the first swing; the phase of an undamped one drifts most
    if (e == 0.5) {
      s.run(12000);
      // Static limit: three springs in a row share 0.2 mm, and each carries the weights above it.
      const double overlap_high = (0.2e-3 * k - m1 * g - 2 * m2 * g) / (3 * k);
      const double overlap_middle = overlap_high + m2 * g / k, overlap_low = overlap_middle + m1 * g / k;
      CHECK(overlap_low + overlap_middle + overlap_high == within(1e-12, 0.2e-3));
      CHECK(position(s, 0).z == near(1e-10, r - overlap_low));
      CHECK(position(s, 1).z == near(1e-10, top - r + overlap_high));
    }
  }
}

TEST_CASE("Chung and Ooi 1 and 2: peak force, peak overlap and duration of elastic Hertz impacts") {
  // Values of physics 4.7 F from the closed form (Johnson 1985, section 11.4); digitised curve of test 1: 10.18 kN, 265 um.
  struct impact {
    double radius, young, poisson, density, speed;
    bool wall;
    double force, overlap, duration;
  };
  for (const impact& c : {impact{0.01, 48e9, 0.2, 2800, 10, false, 10.697e3, 274.1e-6, 40.34e-6},
                          impact{0.1, 70e9, 0.3, 2699, 0.2, true, 11.370e3, 49.72e-6, 731.7e-6}}) {
    const double dt = c.duration / 2000;
    const auto run = [&](auto&& s, double start_gap, auto&& overlap) {
      double deepest = 0, first = -1, last = -1;
      const double ahead = start_gap / (c.wall ? c.speed : 2 * c.speed);
      while (s.time() < ahead + 1.2 * c.duration) {
        s.run(1);
        const double now = overlap(s);
        deepest = std::max(deepest, now);
        if (now > 0) last = s.time();
        if (now > 0 && first < 0) first = s.time();
      }
      CHECK(deepest == within(2e-3, c.overlap));
      CHECK(last - first == within(2e-3, c.duration));
      return deepest;
    };
    const material m{normal::hertz{c.young, c.poisson}};
    const double start = 0.3 * c.speed * dt, equivalent = c.young / (2 * (1 - c.poisson * c.poisson));
    if (c.wall) {
      // A rigid plane: E* = E / (1 - nu^2), that is twice the E* of the law, which has the wall of the grain's material.
      const material rigid{normal::hertz{2 * c.young, c.poisson}};
      pendular::system s{rigid, floor_plane(), velocity_verlet{dt}, run_options{.force = true}};
      s.add({{0, 0, c.radius + start}, c.radius, c.density, {0, 0, -c.speed}});
      const double deepest = run(s, start, [&](auto& x) { return c.radius - position(x, 0).z; });
      CHECK(4.0 / 3 * 2 * equivalent * std::sqrt(c.radius) * std::pow(deepest, 1.5) == within(3e-3, c.force));
      CHECK(velocity(s, 0).z == within(1e-5, c.speed));
    } else {
      pendular::system s{m, boundary::walls{}, velocity_verlet{dt}, run_options{.force = true}};
      s.add({{0, 0, 0}, c.radius, c.density, {c.speed, 0, 0}});
      s.add({{2 * c.radius + start, 0, 0}, c.radius, c.density, {-c.speed, 0, 0}});
      double peak = 0;
      run(s, start, [&](auto& x) {
        if (x.pairs().size() > 0) peak = std::max(peak, norm(x.contacts().force(0)));
        return -gap_of(x, 0, 1);
      });
      CHECK(peak == within(2e-3, c.force));
      CHECK(velocity(s, 1).x == within(1e-5, c.speed));
    }
  }
}

TEST_CASE("Chung and Ooi 3: the restitution asked of a Hertz contact is the one found") {
  // A dashpot 2 a sqrt(m k_tangent) on a Hertz spring: e depends on a alone, a = sqrt(5/6) |ln e| / sqrt(pi^2 + ln^2 e)
  // (Antypov and Elliott 2011, EPL 94, 50004).
  for (const double e : {0.2, 0.4, 0.6, 0.8}) {
    const double rate = std::sqrt(5.0 / 6) * damping_rate_for(e), r = 2.5e-3;
    for (const double v : {0.1, 3.9}) {
      pendular::system s{material{normal::hertz{380e9, 0.23}, damping::viscous{rate}}, floor_plane(),
                         velocity_verlet{1e-8 * std::pow(v / 3.9, -0.2)}, run_options{.force = true}};
      s.add({{0, 0, r * (1 + 1e-7)}, r, 4000, {0, 0, -v}});
      while (velocity(s, 0).z < 0 || position(s, 0).z < r) s.run(1);
      CHECK(velocity(s, 0).z / v == near(2e-3, e));
    }
  }
}
