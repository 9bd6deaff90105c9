// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/material.hpp>
#include <pendular/core/fields.hpp>
#include <pendular/core/none.hpp>
#include <pendular/law/resistance.hpp>
#include <pendular/law/stiffness.hpp>

#include <type_traits>

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
/// Every vector of a memory, those of its members included.
template <class T, class Memory>
void follow_all(Memory& memory, const Vec3<T>& normal, const T& twist) {
  for_each_field(memory, [&]<class Member>(Member& member) {
    if constexpr (std::is_same_v<Member, Vec3<T>>) {
      follow(member, normal, twist);
    } else if constexpr (!std::is_same_v<Member, T>) {
      follow_all(member, normal, twist);
    }
  });
}
}  // namespace detail

/// Whether friction or damping that is not prepared asks for the reduced mass of every contact in every step.
template <class Material>
inline constexpr bool keeps_reduced_mass = Material::has_friction ||
                                           (Material::has_damping && !Material::prepares_dashpot);

namespace detail {
template <class T, bool KeepsMass, bool KeepsDashpot>
struct kept_constants {
  T reduced_mass;  // kg
  prepared_dashpot<T> damping;
};
template <class T>
struct kept_constants<T, true, false> {
  T reduced_mass;
  static constexpr none damping{};
};
template <class T>
struct kept_constants<T, false, true> {
  prepared_dashpot<T> damping;
};
template <class T>
struct kept_constants<T, false, false> {
  static constexpr none damping{};
};
}  // namespace detail

/// What of a contact is the same as long as its pair is, and is kept: no number that no law of the material asks for.
template <class T, class Material>
using contact_constants = detail::kept_constants<T, keeps_reduced_mass<Material>, Material::prepares_dashpot>;

template <class T, class Material>
contact_constants<T, Material> constants_of(const Material& material, const T& reduced_mass) {
  contact_constants<T, Material> c;
  if constexpr (keeps_reduced_mass<Material>) c.reduced_mass = reduced_mass;
  if constexpr (Material::prepares_dashpot) {
    const approach<T> a{T(0), T(0), reduced_mass, T(1), T(1)};
    c.damping = material.damping().prepare(reduced_mass, stiffness(material.normal(), a));
  }
  return c;
}

namespace detail {
/// Tangent of the spring, where the dashpot is not prepared. To be asked before the push, which may change the memory.
template <class T, class Material, class Memory>
T tangent(const Material& material, const approach<T>& a, const Memory& memory) {
  if constexpr (Material::has_damping && !Material::prepares_dashpot) {
    using law = typename Material::normal_law;
    return ask_with<law, T>([&](const auto&... own) { return stiffness(material.normal(), a, own...); },
                            part_of<law>(memory));
  } else {
    return T(0);
  }
}

template <class T, class Material, class Memory>
T repulsion(const Material& material, const approach<T>& a, Memory& memory) {
  using law = typename Material::normal_law;
  return ask_with<law, T>([&](auto&... own) -> T { return material.normal().repulsion(a, own...); },
                          part_of<law>(memory));
}

template <class T, class Material, class Prepared, class Memory>
T damping(const Material& material, const approach<T>& a, const elastic<T>& spring, const Prepared& prepared,
          Memory& memory) {
  using law = typename Material::damping_law;
  if constexpr (Material::prepares_dashpot) {
    return ask_with<law, T>([&](auto&... own) -> T { return material.damping().resistance(a, prepared, own...); },
                            part_of<law>(memory));
  } else {
    return resistance(material.damping(), a, spring, part_of<law>(memory));
  }
}

template <class T, class Material, class Memory>
Vec3<T> traction(const Material& material, const slip<T>& s, const T& normal_force, Memory& memory) {
  using law = typename Material::friction_law;
  return ask_with<law, T>(
      [&](auto&... own) -> Vec3<T> { return material.friction().traction(s, normal_force, own...); },
      part_of<law>(memory));
}
}  // namespace detail

/// Elastic push, damping and friction of one material. The Coulomb limit takes elastic + damping, floored at 0, and
/// never the total force, which would delete cohesion (Richefeu et al. 2007, Eq. 12). `prepared` is the damping of
/// contact_constants.
template <class T, class Material, class Prepared, class Memory>
contact_force<T> touch(const Material& material, const encounter<T>& e, const Prepared& prepared, Memory& memory,
                       double time_step) {
  if constexpr (Material::has_memory) {
    detail::follow_all(memory, e.normal, Material::has_friction ? e.twist : T(0));
  }
  const T tangent = detail::tangent(material, e.approaching, memory);
  const T push = detail::repulsion(material, e.approaching, memory);
  contact_force<T> result{push, T(0), {T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
  if constexpr (Material::has_damping) {
    result.damping = detail::damping(material, e.approaching, elastic<T>{push, tangent}, prepared, memory);
    result.push = push + result.damping;
  }
  if constexpr (Material::has_friction) {
    result.slip_rate = tangential_part(e.velocity, e.normal) + e.rolling;
    const slip<T> s{result.slip_rate, e.normal, e.tangential_mass, e.contacts, time_step};
    const T normal_force = max(result.push, T(0));
    result.traction = detail::traction(material, s, normal_force, memory);
  }
  return result;
}

/// The same for a contact whose constants nobody keeps.
template <class T, class Material, class Memory>
contact_force<T> touch(const Material& material, const encounter<T>& e, Memory& memory, double time_step) {
  return touch(material, e, constants_of(material, e.approaching.reduced_mass).damping, memory, time_step);
}

}  // namespace pendular
