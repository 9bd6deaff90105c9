// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenes.hpp"

#include <algorithm>
#include <array>
#include <limits>

// Scenes with a closed form for the comparison of integrators. Every one takes the steps per contact t_c / dt, t_c = pi
// sqrt(m / k) of a pair or of a grain at a wall, and answers an error.
namespace integrator_scenes {

using namespace scenes;
using pendular::half_step_velocity_verlet;
using pendular::material;
using pendular::run_options;
using pendular::velocity_verlet;
namespace boundary = pendular::boundary;
namespace damping = pendular::damping;
namespace friction = pendular::friction;
namespace normal = pendular::normal;

/// A sphere that flies along x into a plane (second radius 0) or a second sphere, and slips along y.
struct impact {
  double radius, density, second_radius, second_density;
  double approach;               // relative speed along the normal, m/s; of two spheres, shared by their masses
  double sideways, spin, spin2;  // m/s of the first; rad/s of both about z
  double mu, restitution;
};

/// Velocity along x and y and R times the spin of a body.
struct body {
  double x = 0, y = 0, turn = 0;
};
struct pair_state {
  body first, second;
};

inline double slip_of(const pair_state& p) { return p.first.y + p.first.turn - p.second.y + p.second.turn; }

inline pair_state before(const impact& c) {
  const bool wall = c.second_radius == 0;
  const double m1 = sphere_mass(c.radius, c.density), m2 = sphere_mass(c.second_radius, c.second_density);
  return {{wall ? c.approach : c.approach * m2 / (m1 + m2), c.sideways, c.radius * c.spin},
          {wall ? 0.0 : -c.approach * m1 / (m1 + m2), 0, c.second_radius * c.spin2}};
}

/// Closed form of an impact that slides throughout: mu times the normal impulse. A two-sided dashpot pulls at the end,
/// where Coulomb's law gives no friction: the pushing part of the impulse is 1 + exp(-2 a arccos a / sqrt(1 - a^2))
/// times m v, and 1 + e that of the whole (Schwager and Poeschel 2007, Granular Matter 9, 465).
inline pair_state after(const impact& c) {
  pair_state p = before(c);
  const double a = c.restitution < 1 ? damping_rate_for(c.restitution) : 0;
  const double pushing = 1 + std::exp(-2 * a * std::acos(a) / std::sqrt(1 - a * a));
  const double m1 = sphere_mass(c.radius, c.density), m2 = sphere_mass(c.second_radius, c.second_density);
  const double share2 = m2 > 0 ? m1 / (m1 + m2) : 0;  // of the change of relative velocity
  const double slip = slip_of(p), rub = slip == 0 ? 0 : std::copysign(c.mu * pushing * c.approach, slip);
  const double turn = (1 + c.restitution) * c.approach;
  p.first = {p.first.x - (1 - share2) * turn, p.first.y - (1 - share2) * rub, p.first.turn - 2.5 * (1 - share2) * rub};
  p.second = {p.second.x + share2 * turn, p.second.y + share2 * rub, p.second.turn - 2.5 * share2 * rub};
  return p;
}

struct impact_errors {
  double normal;    // of the restitution
  double friction;  // largest of all speeds along y and R times spins, over mu (1 + e) v; over v if nothing slips
};

inline impact_errors compared(const impact& c, const pair_state& found) {
  const pair_state exact = after(c);
  const double rub = slip_of(before(c)) == 0 ? c.approach : c.mu * (1 + c.restitution) * c.approach;
  const auto off = [](const body& a, const body& b) {
    return std::max(std::abs(a.y - b.y), std::abs(a.turn - b.turn));
  };
  const double e_found = (found.second.x - found.first.x) / c.approach;
  return {std::abs(e_found - c.restitution),
          std::max(off(found.first, exact.first), off(found.second, exact.second)) / rub};
}

/// Many copies of one impact that differ in where inside a step the surfaces meet; `visit` sees the outcome of each.
template <class Integration, class Walls, class Visit>
void fly(const impact& c, const Walls& walls, double k, double kt, double omega, double steps, const Visit& visit) {
  constexpr int phases = 16;
  const double dt = pi / omega / steps;
  const double a = c.restitution < 1 ? damping_rate_for(c.restitution) : 0;
  pendular::system s{material{normal::linear{k}, damping::viscous{a}, friction::coulomb_spring{kt, c.mu}}, walls,
                     Integration{dt}, run_options{.force = true}};
  const pair_state start = before(c);
  const bool pair = c.second_radius > 0;
  for (int n = 0; n < phases; ++n) {
    const double gap = (3.0 + (n + 0.5) / phases) * c.approach * dt, z = 4 * std::max(c.radius, c.second_radius) * n;
    s.add({{-c.radius - gap, 0, z}, c.radius, c.density, {start.first.x, start.first.y, 0}, {0, 0, c.spin}});
    if (pair)
      s.add({{c.second_radius, 0, z}, c.second_radius, c.second_density, {start.second.x, 0, 0}, {0, 0, c.spin2}});
  }
  s.run(std::llround(1.2 * steps) + 10);
  for (int n = 0; n < phases; ++n) {
    const std::int64_t first = pair ? 2 * n : n;
    const auto of = [&](std::int64_t id, double r) {
      return body{velocity(s, id).x, velocity(s, id).y, r * spin(s, id).z};
    };
    visit(pair_state{of(first, c.radius), pair ? of(first + 1, c.second_radius) : body{}});
  }
}

/// With springs so stiff that the overlap shortens no lever arm by more than 1e-4; kt is in units of k.
template <class Integration, class Visit>
void fly(const impact& c, double kt, double steps, const Visit& visit) {
  const double m1 = sphere_mass(c.radius, c.density), m2 = sphere_mass(c.second_radius, c.second_density);
  const double mass = m2 > 0 ? m1 * m2 / (m1 + m2) : m1;
  const double omega = c.approach / (1e-4 * c.radius), k = mass * omega * omega;
  if (m2 > 0) return fly<Integration>(c, boundary::walls{}, k, kt * k, omega, steps, visit);
  const boundary::walls plate{boundary::wall{boundary::plane{{0, 0, 0}, {-1, 0, 0}}}};
  fly<Integration>(c, plate, k, kt * k, omega, steps, visit);
}

/// Largest errors over the phases of an impact that slides throughout. At k_t = 8 k friction follows the jump of the
/// dashpot at first touch fast enough.
template <class Integration>
impact_errors sliding_impact(const impact& c, double steps) {
  impact_errors worst{0, 0};
  fly<Integration>(c, 8.0, steps, [&](const pair_state& found) {
    const impact_errors now = compared(c, found);
    worst = {std::max(worst.normal, now.normal), std::max(worst.friction, now.friction)};
  });
  return worst;
}

/// An impact that sticks throughout: at k_t = 2/7 k the tangential spring swings at the pace of the normal one and its
/// force stays proportional to the push, so that the slip is turned round, exactly. Error over the slip.
template <class Integration>
double sticking_impact(double steps) {
  const double vn = 0.2, mu = 0.4, slip = 0.5 * mu * 3.5 * vn;
  const impact c{0.1, 2700, 0, 0, vn, slip, 0, 0, mu, 1};
  double worst = 0;
  fly<Integration>(c, 2.0 / 7, steps,
                   [&](const pair_state& found) { worst = std::max(worst, std::abs(slip_of(found) / slip + 1)); });
  return worst;
}

// Chung and Ooi 2011, Granular Matter 13, 643, tests 4 to 8, in gross sliding.
inline impact chung_4(double degrees) {
  const double angle = degrees * pi / 180;
  return {2.5e-3, 4000, 0, 0, 3.9 * std::cos(angle), 3.9 * std::sin(angle), 0, 0, 0.092, 0.98};
}
inline impact chung_5(double tangent) { return {1e-5, 7850, 0, 0, 5, 5 * tangent, 0, 0, 0.3, 1}; }
inline impact chung_6(double tangent) { return {0.1, 2700, 0, 0, 0.2, 0, 0.2 * tangent / 0.1, 0, 0.4, 0.5}; }
inline impact chung_7(double tangent, double sense) {
  const double spin = 0.2 * tangent / 0.1;
  return {0.1, 2700, 0.1, 2700, 0.4, 0, spin, sense * spin, 0.4, 0.5};
}
inline impact chung_8(double tangent) { return {0.1, 2700, 0.5, 2.7e6, 0.2, 0, 0.2 * tangent / 0.1, 0, 0.4, 0.5}; }

/// A sphere on an incline, released at the sag of rest: error of its acceleration, of the sphere's surface in the case
/// of sliding too.
template <class Integration>
double incline(double degrees, double steps) {
  const double r = 0.5e-3, k = 1e3, g = 9.81, mu = 0.2, mass = sphere_mass(r, 2600), beta = degrees * pi / 180;
  const double sag = mass * g * std::cos(beta) / k, dt = pi * std::sqrt(mass / k) / steps;
  pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, friction::coulomb_spring{800, mu}},
                     floor_plane(), Integration{dt, {g * std::sin(beta), 0, -g * std::cos(beta)}},
                     run_options{.force = true}};
  s.add({{0, 0, r - sag}, r, 2600});
  s.run(std::llround(0.02 / dt));
  const bool rolls = std::tan(beta) < 3.5 * mu;
  const double linear = rolls ? 5.0 / 7 * g * std::sin(beta) : g * (std::sin(beta) - mu * std::cos(beta));
  const double angular = rolls ? linear : 2.5 * mu * g * std::cos(beta);
  return std::max(std::abs(velocity(s, 0).x / s.time() / linear - 1),
                  std::abs(spin(s, 0).y * r / s.time() / angular - 1));
}

/// A grain between two plates, which block its rotation, creeps under its weight at F over twice gamma_t (Eq. 12).
template <class Integration>
double creep(double gamma, double steps) {
  const double r = 0.5e-3, k = 1e3, g = 9.81, squeeze = 1e-6, mass = sphere_mass(r, 2600);
  const double dt = pi * std::sqrt(mass / k) / steps;
  const boundary::walls plates{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                               boundary::wall{boundary::plane{{0, 0, 2 * (r - squeeze)}, {0, 0, -1}}}};
  pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, friction::viscous_coulomb{gamma, 0.4}}, plates,
                     Integration{dt, {g, 0, 0}}, run_options{.force = true}};
  s.add({{0, 0, r - squeeze}, r, 2600});
  s.run(std::llround(30 * mass / (2 * gamma) / dt) + 3000);
  return std::abs(velocity(s, 0).x * 2 * gamma / (mass * g) - 1);
}

}  // namespace integrator_scenes
