// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "integrator_scenes.hpp"

// A small sphere laid, one degree off the top, into the wedge between two held spheres that touch, after the three
// grains of Vyas et al. 2025 (Comput. Phys. Commun. 310, 109524). It rolls down without touching anything else and must
// fall off where its weight no longer presses it into the wedge. Both contacts roll, so that its path is
// that of a rigid wheel on a ring.
namespace between_spheres {

using namespace integrator_scenes;

/// The outside of a held sphere, as a wall.
struct ball {
  vector centre;
  double radius;

  template <pendular::Scalar T>
  boundary::meeting<T> meet(const pendular::Vec3<T>& at, const T& grain_radius) const {
    const pendular::Vec3<T> to{T(centre.x) - at.x, T(centre.y) - at.y, T(centre.z) - at.z};
    const T distance = pendular::norm(to), inverse = T(1) / distance;
    return {T(distance - T(radius) - grain_radius), inverse * to};
  }
};

struct wedge {
  double size_ratio, mu;
  double radius = 0.25e-3, density = 2500, k = 1e4, kt = 8235, g = 9.81, start = pi / 180;

  double mass() const { return sphere_mass(radius, density); }
  double held() const { return size_ratio * radius; }
  double ring() const { return std::sqrt((held() + radius) * (held() + radius) - held() * held()); }
  double sine() const { return ring() / (held() + radius); }   // of the angle of the wedge
  double load() const { return 1 + 0.4 / (sine() * sine()); }  // inertia of rolling over that of the mass
  double duration() const { return 3 * std::acosh(60.0) * std::sqrt(ring() * load() / g); }
};

/// Angle from the top, degrees, where a rigid sphere loses its contacts: it rolls until friction is used up, then
/// slides.
inline double rigid_fall(const wedge& w) {
  const double dt = 1e-7, inertia = w.load() - 1;
  double angle = w.start, rate = 0;
  bool rolls = true;
  while (true) {
    const double press = w.g * std::cos(angle) - w.ring() * rate * rate;  // both pushes times sine, over m
    if (press <= 0) return angle * 180 / pi;
    const double rolling = w.g * std::sin(angle) / w.load(), limit = w.mu * press / w.sine();
    rolls = rolls && inertia * rolling <= limit;
    rate += dt / w.ring() * (rolls ? rolling : w.g * std::sin(angle) - limit);
    angle += dt * rate;
  }
}

struct fall {
  double angle;       // where the contacts are lost, degrees from the top; infinite if they never are
  double held_force;  // largest push of one held sphere along the line of their centres, over the weight
};

template <class Integration, class Friction>
fall fallen(const wedge& w, double steps, const Friction& law) {
  const double dt = pi * std::sqrt(w.mass() / w.k) / steps;
  const boundary::walls two{boundary::wall{ball{{-w.held(), 0, 0}, w.held()}},
                            boundary::wall{ball{{w.held(), 0, 0}, w.held()}}};
  pendular::system s{material{normal::linear{w.k}, damping::viscous{damping_rate_for(0.5)}, law}, two,
                     Integration{dt, {0, 0, -w.g}}, run_options{.force = true}};
  s.add({{0, w.ring() * std::sin(w.start), w.ring() * std::cos(w.start)}, w.radius, w.density});
  fall f{0, 0};
  while (s.time() < w.duration()) {
    s.run(5);
    const vector p = position(s, 0);
    const double push = pendular::norm(boundary::get<0>(s.walls()).force);
    f.held_force = std::max(f.held_force, push / (w.mass() * w.g));
    if (push > 0) f.angle = std::atan2(p.y, p.z) * 180 / pi;
    if (std::hypot(p.y, p.z) > 1.005 * w.ring()) return f;
  }
  f.angle = std::numeric_limits<double>::infinity();
  return f;
}

template <class Integration>
fall fallen(const wedge& w, double steps) {
  return fallen<Integration>(w, steps, friction::coulomb_spring{w.kt, w.mu});
}

}  // namespace between_spheres
