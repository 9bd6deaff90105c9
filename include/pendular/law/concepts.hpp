// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace pendular {

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

/// What a law keeps per contact: a nested template `contact_memory<T>` whose members are T or Vec3<T>, or nothing.
template <class L, class T>
using contact_memory_t = typename detail::memory_of<L, T>::type;

namespace detail {
// What a law answers if it is asked in T; no type if it cannot be asked.
template <class L, class T>
using repulsion_t = decltype(std::declval<const L&>().repulsion(std::declval<const approach<T>&>()));
template <class L, class T>
using resistance_t =
    decltype(std::declval<const L&>().resistance(std::declval<const approach<T>&>(), std::declval<const T&>()));
template <class L, class T>
using dashpot_t = decltype(std::declval<const L&>().prepare(std::declval<const T&>(), std::declval<const T&>()));
template <class L, class T>
using prepared_resistance_t =
    decltype(std::declval<const L&>().resistance(std::declval<const approach<T>&>(), std::declval<dashpot_t<L, T>>()));
template <class L, class T>
using distance_t =
    decltype(std::declval<const L&>().distance(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using bridge_resistance_t =
    decltype(std::declval<const L&>().resistance(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using simple_attraction_t =
    decltype(std::declval<const L&>().attraction(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using coefficients_in_t =
    decltype(std::declval<const L&>().prepare(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using prepared_attraction_t =
    decltype(std::declval<const L&>().attraction(std::declval<const T&>(), std::declval<coefficients_in_t<L, T>>()));

template <class L, class T>
struct traction_of {};
template <class L, class T>
  requires(!Remembers<L, T>)
&&requires(const L law, const slip<T> s, const T n) { law.traction(s, n); }
struct traction_of<L, T> {
  using type = decltype(std::declval<const L&>().traction(std::declval<const slip<T>&>(), std::declval<const T&>()));
};
template <class L, class T>
  requires Remembers<L, T> && requires(const L law, const slip<T> s, const T n, contact_memory_t<L, T>& memory) {
    law.traction(s, n, memory);
  }
struct traction_of<L, T> {
  using type = decltype(std::declval<const L&>().traction(std::declval<const slip<T>&>(), std::declval<const T&>(),
                                                          std::declval<contact_memory_t<L, T>&>()));
};
template <class L, class T>
using traction_t = typename traction_of<L, T>::type;

/// The roles in one scalar.
template <class L, class T>
concept Repels = std::convertible_to<repulsion_t<L, T>, T>;
template <class L, class T>
concept Resists = std::convertible_to<resistance_t<L, T>, T>;
template <class L, class T>
concept Rubs = std::convertible_to<traction_t<L, T>, Vec3<T>>;
template <class L, class T>
concept Breaks = std::convertible_to<distance_t<L, T>, T>;
template <class L, class T>
concept Drags = std::same_as<bridge_resistance_t<L, T>, bridge_resistance<T>>;
template <class L, class T>
concept Attracts = std::convertible_to<simple_attraction_t<L, T>, T>;
template <class L, class T>
concept Prepares = std::same_as < coefficients_in_t<L, T>,
typename L::template coefficients < T >> &&std::convertible_to<prepared_attraction_t<L, T>, T>;

/// A damping law whose part that depends on mass and stiffness alone can be made once per pair.
template <class L, class T = double>
concept PreparesDashpot =
    std::same_as<dashpot_t<L, T>, prepared_dashpot<T>> && std::convertible_to<prepared_resistance_t<L, T>, T>;
}  // namespace detail

/// Elastic push, N, at least 0, zero out of contact.
template <class L>
concept NormalLaw = std::copyable<L> && detail::Repels<L, double>;

/// Signed push, N, that opposes the closing speed, zero out of contact. `stiffness` is the tangent of the normal law.
template <class L>
concept DampingLaw = std::copyable<L> && detail::Resists<L, double>;

/// Force on grain i, N, opposing the slip, never longer than the friction coefficient times the normal force.
template <class L>
concept FrictionLaw = std::copyable<L> && detail::Rubs<L, double>;

/// Pull, N, at least 0, the same from both sides of gap = 0.
template <class L>
concept CapillaryLaw = std::copyable<L> &&(detail::Attracts<L, double> || detail::Prepares<L, double>);

/// Gap at which a bridge breaks, m, growing with its volume.
template <class L>
concept RuptureLaw = std::copyable<L> && detail::Breaks<L, double>;

/// Resistance of a liquid bridge to the motion of its grains, a bridge_resistance, N s/m.
template <class L>
concept ViscousBridgeLaw = std::copyable<L> && detail::Drags<L, double>;

/// A capillary law that knows the work from the gap of a bridge to its rupture distance, J.
template <class L>
concept HasCapillaryEnergy = CapillaryLaw<L> &&
    requires(const L law, const bridge<double> b, const fluid f, const double rupture_distance) {
  { law.energy(b, f, rupture_distance) } -> std::convertible_to<double>;
};

}  // namespace pendular
