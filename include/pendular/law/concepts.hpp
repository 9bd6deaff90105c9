// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/law/inputs.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace pendular {

namespace detail {
struct no_memory {};

/// A law that wraps another hands on its memory as contact_memory_t, which is no_memory if there is none.
template <class L, class T>
concept Remembers = requires {
  typename L::template contact_memory<T>;
  requires !std::is_same_v<typename L::template contact_memory<T>, no_memory>;
};

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
/// Answer<L, T, memory> for a law that remembers, Answer<L, T> for others.
template <template <class, class, class...> class Answer, class L, class T>
struct with_own_memory {};
template <template <class, class, class...> class Answer, class L, class T>
  requires(!Remembers<L, T>)
&&requires { typename Answer<L, T>; }
struct with_own_memory<Answer, L, T> {
  using type = Answer<L, T>;
};
template <template <class, class, class...> class Answer, class L, class T>
  requires Remembers<L, T> && requires { typename Answer<L, T, contact_memory_t<L, T>>; }
struct with_own_memory<Answer, L, T> {
  using type = Answer<L, T, contact_memory_t<L, T>>;
};

// What a law answers if it is asked in T; no type if it cannot be asked. A memory comes last.
template <class L, class T, class... Memory>
using repulsion_by =
    decltype(std::declval<const L&>().repulsion(std::declval<const approach<T>&>(), std::declval<Memory&>()...));
template <class L, class T, class... Memory>
using resistance_by = decltype(std::declval<const L&>().resistance(
    std::declval<const approach<T>&>(), std::declval<const T&>(), std::declval<Memory&>()...));
template <class L, class T, class... Memory>
using resistance_beside_by = decltype(std::declval<const L&>().resistance(
    std::declval<const approach<T>&>(), std::declval<const elastic<T>&>(), std::declval<Memory&>()...));
template <class L, class T>
using dashpot_t = decltype(std::declval<const L&>().prepare(std::declval<const T&>(), std::declval<const T&>()));
template <class L, class T, class... Memory>
using prepared_resistance_by = decltype(std::declval<const L&>().resistance(
    std::declval<const approach<T>&>(), std::declval<dashpot_t<L, T>>(), std::declval<Memory&>()...));
template <class L, class T, class... Memory>
using traction_by = decltype(std::declval<const L&>().traction(std::declval<const slip<T>&>(), std::declval<const T&>(),
                                                               std::declval<Memory&>()...));

template <class L, class T>
using repulsion_t = typename with_own_memory<repulsion_by, L, T>::type;
template <class L, class T>
using resistance_t = typename with_own_memory<resistance_by, L, T>::type;
template <class L, class T>
using resistance_beside_t = typename with_own_memory<resistance_beside_by, L, T>::type;
template <class L, class T>
using prepared_resistance_t = typename with_own_memory<prepared_resistance_by, L, T>::type;
template <class L, class T>
using traction_t = typename with_own_memory<traction_by, L, T>::type;

template <class L, class T>
using distance_t =
    decltype(std::declval<const L&>().distance(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using bridge_resistance_t =
    decltype(std::declval<const L&>().resistance(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using mean_radius_t = decltype(std::declval<const L&>().of(std::declval<const bridge<T>&>()));
template <class L, class T>
using simple_attraction_t =
    decltype(std::declval<const L&>().attraction(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using coefficients_in_t =
    decltype(std::declval<const L&>().prepare(std::declval<const bridge<T>&>(), std::declval<const fluid&>()));
template <class L, class T>
using prepared_attraction_t =
    decltype(std::declval<const L&>().attraction(std::declval<const T&>(), std::declval<coefficients_in_t<L, T>>()));

/// The roles in one scalar.
template <class L, class T>
concept Repels = std::convertible_to<repulsion_t<L, T>, T>;
template <class L, class T>
concept Resists = std::convertible_to<resistance_t<L, T>, T>;
/// Only where the stiffness is not enough, since a second argument of any type takes an `elastic`, too.
template <class L, class T>
concept ResistsBeside = !Resists<L, T> && std::convertible_to<resistance_beside_t<L, T>, T>;
template <class L, class T>
concept Rubs = std::convertible_to<traction_t<L, T>, Vec3<T>>;
template <class L, class T>
concept Breaks = std::convertible_to<distance_t<L, T>, T>;
template <class L, class T>
concept Drags = std::same_as<bridge_resistance_t<L, T>, bridge_resistance<T>>;
template <class L, class T>
concept Averages = std::convertible_to<mean_radius_t<L, T>, T>;
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
concept NormalLaw = Copyable<L> && detail::Repels<L, double>;

/// Signed push, N, that opposes the closing speed, zero out of contact, from the tangent stiffness of the normal law or
/// from its push as well.
template <class L>
concept DampingLaw = Copyable<L> &&(detail::Resists<L, double> || detail::ResistsBeside<L, double>);

/// Force on grain i, N, opposing the slip, never longer than the friction coefficient times the normal force.
template <class L>
concept FrictionLaw = Copyable<L> && detail::Rubs<L, double>;

/// Pull, N, at least 0, the same from both sides of gap = 0.
template <class L>
concept CapillaryLaw = Copyable<L> &&(detail::Attracts<L, double> || detail::Prepares<L, double>);

/// One radius for two, m, of which a capillary law may be a template.
template <class L>
concept MeanRadius = Copyable<L> && detail::Averages<L, double>;

/// Gap at which a bridge breaks, m, growing with its volume.
template <class L>
concept RuptureLaw = Copyable<L> && detail::Breaks<L, double>;

/// Resistance of a liquid bridge to the motion of its grains, a bridge_resistance, N s/m.
template <class L>
concept ViscousBridgeLaw = Copyable<L> && detail::Drags<L, double>;

/// A capillary law that knows the work from the gap of a bridge to its rupture distance, J.
template <class L>
concept HasCapillaryEnergy = CapillaryLaw<L> &&
    requires(const L law, const bridge<double> b, const fluid f, const double rupture_distance) {
  { law.energy(b, f, rupture_distance) } -> std::convertible_to<double>;
};

}  // namespace pendular
