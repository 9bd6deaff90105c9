// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/material.hpp>
#include <pendular/core/fields.hpp>
#include <pendular/law/stiffness.hpp>

namespace pendular {

/// How a grain meets its partner, seen from grain i; the rotational part is filled only where there is friction.
template <class T>
struct encounter {
  approach<T> approaching;
  Vec3<T> normal;     // from i to the partner
  Vec3<T> velocity;   // of centre i relative to the partner, m/s
  Vec3<T> rolling;    // (l_i w_i + l_j w_j) x normal, m/s; l are the lever arms
  T twist;            // turn of the pair about its normal in this step, rad
  T tangential_mass;  // kg
  T contacts;         // as in slip
};

/// Without attraction: force on grain i is -push n + traction.
template <class T>
struct contact_force {
  T push;             // elastic + damping, N
  T damping;          // N, part of push
  Vec3<T> traction;   // N
  Vec3<T> slip_rate;  // of the surface of i over that of its partner, m/s
};

/// A tangential memory vector follows its contact: turned about the normal, laid into the tangent plane, same length.
template <class T>
void follow(Vec3<T>& memory, const Vec3<T>& normal, const T& twist) {
  const T before = dot(memory, memory);
  const Vec3<T> turned = memory + twist * cross(normal, memory);
  const Vec3<T> laid = tangential_part(turned, normal);
  const T after = dot(laid, laid);
  const T factor = sqrt(T(before / max(after, T(tiny * tiny))));
  memory = factor * laid;
}

namespace detail {
template <class T, class Memory>
void follow_all(Memory& memory, const Vec3<T>& normal, const T& twist) {
  for_each_field(memory, [&](auto& member) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(member)>, Vec3<T>>) follow(member, normal, twist);
  });
}

template <class T, class Friction, class Memory>
Vec3<T> traction(const Friction& law, const slip<T>& s, const T& normal_force, Memory& memory) {
  if constexpr (Remembers<Friction, T>) {
    return law.traction(s, normal_force, memory);
  } else {
    return law.traction(s, normal_force);
  }
}
}  // namespace detail

/// What of a contact is the same as long as its pair is.
template <class T>
struct contact_constants {
  T reduced_mass;               // kg
  prepared_dashpot<T> damping;  // 0 unless the material prepares it
};

template <class T, class Material>
contact_constants<T> constants_of(const Material& material, const T& reduced_mass) {
  contact_constants<T> c{reduced_mass, {T(0)}};
  if constexpr (Material::prepares_dashpot) {
    const approach<T> a{T(0), T(0), reduced_mass, T(1), T(1)};
    c.damping = material.damping().prepare(reduced_mass, stiffness(material.normal(), a));
  }
  return c;
}

namespace detail {
template <class T, class Material>
T damping(const Material& material, const approach<T>& a, const prepared_dashpot<T>& prepared) {
  if constexpr (Material::prepares_dashpot) {
    return material.damping().resistance(a, prepared);
  } else {
    return material.damping().resistance(a, stiffness(material.normal(), a));
  }
}
}  // namespace detail

/// Elastic push, damping and friction of one material. The Coulomb limit takes elastic + damping, floored at 0, and
/// never the total force, which would delete cohesion (Richefeu et al. 2007, Eq. 12).
template <class T, class Material, class Memory>
contact_force<T> touch(const Material& material, const encounter<T>& e, const prepared_dashpot<T>& prepared,
                       Memory& memory, double time_step) {
  const T elastic = material.normal().repulsion(e.approaching);
  contact_force<T> result{elastic, T(0), {T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
  if constexpr (Material::has_damping) {
    result.damping = detail::damping(material, e.approaching, prepared);
    result.push = elastic + result.damping;
  }
  if constexpr (Material::has_friction) {
    result.slip_rate = tangential_part(e.velocity, e.normal) + e.rolling;
    const slip<T> s{result.slip_rate, e.normal, e.tangential_mass, e.contacts, time_step};
    const T normal_force = max(result.push, T(0));
    if constexpr (Material::has_memory) detail::follow_all(memory, e.normal, e.twist);
    result.traction = detail::traction(material.friction(), s, normal_force, memory);
  }
  return result;
}

/// The same for a contact whose constants nobody keeps.
template <class T, class Material, class Memory>
contact_force<T> touch(const Material& material, const encounter<T>& e, Memory& memory, double time_step) {
  return touch(material, e, constants_of(material, e.approaching.reduced_mass).damping, memory, time_step);
}

}  // namespace pendular
