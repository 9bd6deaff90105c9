// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

#include <algorithm>
#include <cmath>

// Laws that model their concept and break one promise each, after mistakes seen in public code or easily made.
namespace pendular::bad {

// Normal ---------------------------------------------------------------------------------------------------------------

/// Overlap to a power, wrong in one way.
struct bad_spring {
  enum class mistake { none, pulls_apart, shallow, preloaded, lopsided, wrong_energy, wrong_stiffness } made;

  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    const T size = T(1) / (T(1) / a.radius_i + T(1) / a.radius_j);
    if (made == mistake::pulls_apart) return T(-a.gap);
    if (made == mistake::shallow) return min(overlap, T(1e-3 * 5e-4));
    if (made == mistake::preloaded) return overlap + T(1e-5) * unit_step(T(-a.gap));
    if (made == mistake::lopsided) return overlap * (size + T(1e-3) * min(a.radius_i, T(1)));
    return overlap;
  }
  double stiffness(const approach<double>& a) const {
    if (made == mistake::wrong_stiffness) return 2.0;
    return made == mistake::lopsided ? 1.0 / (1.0 / a.radius_i + 1.0 / a.radius_j) + 1e-3 * std::min(a.radius_i, 1.0)
                                     : 1.0;
  }
  double energy(const approach<double>& a) const {
    const double overlap = max(-a.gap, 0.0);
    return (made == mistake::wrong_energy ? 1.0 : 0.5) * overlap * stiffness(a) * overlap;
  }
};

/// Stiffer the deeper, and says it is not.
struct spring_said_to_be_linear {
  static constexpr bool has_constant_stiffness = true;

  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    return overlap * overlap;
  }
};

struct spring_in_double_only {
  double repulsion(const approach<double>& a) const { return max(-a.gap, 0.0); }
};
struct spring_that_mixes_lanes {
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    if constexpr (detail::Lanes<T>) {
      return T(overlap[0]);
    } else {
      return overlap;
    }
  }
};
struct spring_that_blows_up {
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
    return overlap * a.radius_j / a.radius_j;
  }
};

// Damping --------------------------------------------------------------------------------------------------------------

struct bad_dashpot {
  enum class mistake { none, as_printed, everywhere, dry_friction, lopsided, blows_up } made;

  template <Scalar T>
  T resistance(const approach<T>& a, const T& stiffness) const {
    const T touching = unit_step(T(-a.gap));
    const T force = sqrt(T(a.reduced_mass * stiffness)) * a.closing_speed;
    if (made == mistake::as_printed) return -force * touching;
    if (made == mistake::everywhere) return force;
    if (made == mistake::dry_friction) return (force + T(1e-6) * unit_step(T(a.closing_speed + T(1e-9)))) * touching;
    if (made == mistake::lopsided) return force * touching * min(a.radius_i, T(1));
    if (made == mistake::blows_up) return force * touching * (stiffness / stiffness);
    return force * touching;
  }
};
struct dashpot_prepared_wrongly : bad_dashpot {
  dashpot_prepared_wrongly() : bad_dashpot{mistake::none} {}
  using bad_dashpot::resistance;
  prepared_dashpot<double> prepare(double reduced_mass, double stiffness) const {
    return {std::sqrt(reduced_mass + stiffness)};
  }
  double resistance(const approach<double>& a, const prepared_dashpot<double>& made_before) const {
    return made_before.coefficient * a.closing_speed * unit_step(-a.gap);
  }
};
/// Lets a new contact begin with what the last one was.
struct dashpot_that_never_forgets {
  template <class T>
  struct contact_memory {
    T fastest;
  };
  template <Scalar T>
  T resistance(const approach<T>& a, const T&, contact_memory<T>& memory) const {
    memory.fastest = max(memory.fastest, a.closing_speed);
    return memory.fastest * a.closing_speed * unit_step(T(-a.gap));
  }
};
struct spring_that_never_forgets {
  template <class T>
  struct contact_memory {
    T deepest;
  };
  template <Scalar T>
  T repulsion(const approach<T>& a, contact_memory<T>& memory) const {
    const T overlap = max(T(-a.gap), T(0));
    memory.deepest = max(memory.deepest, overlap);
    return max(T(T(2) * overlap - memory.deepest), T(0));
  }
};
struct dashpot_in_double_only {
  double resistance(const approach<double>& a, double) const { return a.closing_speed * unit_step(-a.gap); }
};

// Friction -------------------------------------------------------------------------------------------------------------

struct bad_friction {
  enum class mistake { none, pushes, uncapped, zero_by_zero, breakaway, along_normal, skewed } made;

  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force) const {
    const T limit = T(0.4) * normal_force;
    const Vec3<T> viscous = T(-0.1) * s.velocity;
    if (made == mistake::pushes) return shortened_to(Vec3<T>(-viscous), limit);
    if (made == mistake::uncapped) return viscous;
    if (made == mistake::zero_by_zero) return T(limit / norm(viscous)) * viscous;
    if (made == mistake::breakaway) return shortened_to(Vec3<T>{limit * s.normal.y, -limit * s.normal.x, T(0)}, limit);
    if (made == mistake::along_normal) return shortened_to(Vec3<T>(viscous - norm(viscous) * s.normal), limit);
    if (made == mistake::skewed) return shortened_to(Vec3<T>(viscous + T(0.1) * cross(s.normal, viscous)), limit);
    return shortened_to(viscous, limit);
  }
};

/// A spring whose cap is applied to what it remembers, not to what it returns.
struct spring_capped_too_late {
  template <class T>
  struct contact_memory {
    Vec3<T> force;
  };
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force, contact_memory<T>& memory) const {
    const Vec3<T> trial = memory.force - T(10.0 * s.time_step) * s.velocity;
    memory.force = shortened_to(trial, T(T(0.4) * normal_force));
    return trial;
  }
};
struct friction_in_double_only {
  Vec3<double> traction(const slip<double>& s, double normal_force) const {
    return shortened_to(-s.velocity, 0.4 * normal_force);
  }
};

// Capillary ------------------------------------------------------------------------------------------------------------

struct bad_bridge {
  enum class mistake {
    none,
    repels,
    gap_only,  // no attraction in overlap, as one public code has it
    grows,
    larger_radius_j,  // the radius of j in place of the mean
    dimensional,      // a power of the volume in m3, as another has it
    wrong_energy,     // without the work in overlap
    dries_to_nan,     // 0 * inf as the volume vanishes, as a third has it
  } made;

  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    const T mean = T(2) * b.radius_i * b.radius_j / (b.radius_i + b.radius_j);
    const T open = max(b.gap, T(0));
    const T length = cbrt(b.volume);
    const T reach = T(1e-30) + length;
    const T decay = exp(T(-open / reach));
    const T touch = T(f.surface_tension) * mean;
    if (made == mistake::repels) return touch * (decay - T(0.5));
    if (made == mistake::gap_only) return touch * decay * (T(1) - unit_step(T(-b.gap)));
    if (made == mistake::grows) return touch * (T(2) - decay);
    if (made == mistake::larger_radius_j) return T(f.surface_tension) * b.radius_j * decay;
    if (made == mistake::dimensional) return touch * decay * sqrt(length);
    if (made == mistake::dries_to_nan) return touch * exp(T(-open / length));
    return touch * decay;
  }
};
struct bridge_with_wrong_energy : bad_bridge {
  double energy(const bridge<double>& b, const fluid& f, double rupture_distance) const {
    const double reach = cbrt(b.volume);
    const double open = max(b.gap, 0.0);
    const double touch = attraction(bridge<double>{0.0, b.volume, b.radius_i, b.radius_j}, f);
    return touch * reach * max(std::exp(-open / reach) - std::exp(-rupture_distance / reach), 0.0);
  }
};
struct bridge_of_two_minds : bad_bridge {
  template <class T>
  struct coefficients {
    T force;
  };
  template <Scalar T>
  coefficients<T> prepare(const bridge<T>& b, const fluid& f) const {
    return {T(f.surface_tension) * b.radius_i};
  }
  using bad_bridge::attraction;
  template <Scalar T>
  T attraction(const T&, const coefficients<T>& c) const {
    return c.force;
  }
};
struct bridge_in_double_only {
  double attraction(const bridge<double>& b, const fluid&) const { return b.radius_i + b.radius_j; }
};

// Rupture --------------------------------------------------------------------------------------------------------------

struct bad_rupture {
  enum class mistake { none, shrinks, film, of_the_gap, lopsided, dimensional, blows_up } made;

  template <Scalar T>
  T distance(const bridge<T>& b, const fluid&) const {
    const T length = cbrt(b.volume);
    if (made == mistake::shrinks) return length / (T(1) + b.volume * T(1e15) / b.radius_i);
    if (made == mistake::film) return length + T(1e-3) * min(b.radius_i, b.radius_j);
    if (made == mistake::of_the_gap) return length * (T(1) + max(b.gap, T(0)) / (b.radius_i + b.radius_j));
    if (made == mistake::lopsided) return length * (T(1) + length / b.radius_i);
    if (made == mistake::dimensional) return length * sqrt(length);
    if (made == mistake::blows_up) return length * (length / length);
    return length;
  }
};
struct rupture_in_double_only {
  double distance(const bridge<double>& b, const fluid&) const { return cbrt(b.volume); }
};

// Viscous bridge -------------------------------------------------------------------------------------------------------

struct bad_drag {
  enum class mistake { none, drives, dry, lopsided, blows_up } made;

  template <Scalar T>
  bridge_resistance<T> resistance(const bridge<T>& b, const fluid& f) const {
    const T length = T(f.viscosity) * cbrt(b.volume);
    if (made == mistake::drives) return {length, -length};
    if (made == mistake::dry) return {length, length + T(f.viscosity) * min(b.radius_i, b.radius_j)};
    if (made == mistake::lopsided) return {length * (T(1) + length / b.radius_i), length};
    if (made == mistake::blows_up) return {length * (T(1) + unit_step(T(-b.gap)) / max(T(b.gap), T(0))), length};
    return {length, length};
  }
};
struct drag_in_double_only {
  bridge_resistance<double> resistance(const bridge<double>& b, const fluid& f) const {
    return {f.viscosity * cbrt(b.volume), 0};
  }
};

}  // namespace pendular::bad
