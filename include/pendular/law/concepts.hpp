// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

#include <concepts>
#include <type_traits>

namespace pendular {

/// Elastic push, N, at least 0, zero out of contact.
template <class L>
concept NormalLaw = std::copyable<L> && requires(const L law, const approach<double> a) {
  { law.repulsion(a) } -> std::convertible_to<double>;
};

/// Signed push, N, that opposes the closing speed, zero out of contact. `stiffness` is the tangent of the normal law.
template <class L>
concept DampingLaw = std::copyable<L> && requires(const L law, const approach<double> a, const double stiffness) {
  { law.resistance(a, stiffness) } -> std::convertible_to<double>;
};

namespace detail {
template <class L, class T>
concept Remembers = requires {
  typename L::template contact_memory<T>;
};

struct no_memory {};
template <class L, class T>
struct memory_of {
  using type = no_memory;
};
template <class L, class T>
  requires Remembers<L, T>
struct memory_of<L, T> {
  using type = typename L::template contact_memory<T>;
};
}  // namespace detail

namespace detail {
/// A damping law whose part that depends on mass and stiffness alone can be made once per pair.
template <class L>
concept PreparesDashpot = requires(const L law, const approach<double> a, const double number) {
  { law.prepare(number, number) } -> std::same_as<prepared_dashpot<double>>;
  { law.resistance(a, law.prepare(number, number)) } -> std::convertible_to<double>;
};
}  // namespace detail

/// What a law keeps per contact: a nested template `contact_memory<T>` whose members are T or Vec3<T>, or nothing.
template <class L, class T>
using contact_memory_t = typename detail::memory_of<L, T>::type;

/// Force on grain i, N, opposing the slip, never longer than the friction coefficient times the normal force.
template <class L>
concept FrictionLaw = std::copyable<L> &&(
    requires(const L law, const slip<double> s, const double normal_force) {
      { law.traction(s, normal_force) } -> std::convertible_to<Vec3<double>>;
    } ||
    requires(const L law, const slip<double> s, const double normal_force, contact_memory_t<L, double>& memory) {
      requires detail::Remembers<L, double>;
      { law.traction(s, normal_force, memory) } -> std::convertible_to<Vec3<double>>;
    });

namespace detail {
template <class L, class T>
concept Prepares = requires(const L law, const bridge<T> b, const fluid f, const T gap) {
  { law.prepare(b, f) } -> std::same_as<typename L::template coefficients<T>>;
  { law.attraction(gap, law.prepare(b, f)) } -> std::convertible_to<T>;
};
template <class L, class T>
concept Attracts = requires(const L law, const bridge<T> b, const fluid f) {
  { law.attraction(b, f) } -> std::convertible_to<T>;
};
}  // namespace detail

/// Pull, N, at least 0, the same from both sides of gap = 0.
template <class L>
concept CapillaryLaw = std::copyable<L> &&(detail::Attracts<L, double> || detail::Prepares<L, double>);

/// Gap at which a bridge breaks, m, growing with its volume.
template <class L>
concept RuptureLaw = std::copyable<L> && requires(const L law, const bridge<double> b, const fluid f) {
  { law.distance(b, f) } -> std::convertible_to<double>;
};

/// Resistance of a liquid bridge to the motion of its grains, a bridge_resistance, N s/m.
template <class L>
concept ViscousBridgeLaw = std::copyable<L> && requires(const L law, const bridge<double> b, const fluid f) {
  { law.resistance(b, f) } -> std::same_as<bridge_resistance<double>>;
};

/// A capillary law that knows the work from the gap of a bridge to its rupture distance, J.
template <class L>
concept HasCapillaryEnergy = CapillaryLaw<L> &&
    requires(const L law, const bridge<double> b, const fluid f, const double rupture_distance) {
  { law.energy(b, f, rupture_distance) } -> std::convertible_to<double>;
};

}  // namespace pendular
