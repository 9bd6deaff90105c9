// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/core/never.hpp>
#include <pendular/law/every_scalar.hpp>

namespace pendular::check {

// One sentence per broken clause: what is missing, what to write, where to read. Each ladder is true or stops the
// compilation at its first broken clause, so that `static_assert(check::capillary_law<my_law>)` says what to do.

namespace detail {
using namespace pendular::detail;
}  // namespace detail

template <class L>
consteval bool is_normal_law() {
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a normal law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires { typename detail::repulsion_t<L, double>; }) {
    static_assert(detail::never<L>, "a normal law needs `template <Scalar T> T repulsion(const approach<T>&) const`, "
                                    "with a second argument `contact_memory<T>&`, a nested template, if it remembers "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::repels_in_every_scalar<L>) {
    static_assert(detail::never<L>, "a normal law must take every scalar, not double alone, because contacts are "
                                    "evaluated in lanes of eight: write `template <Scalar T> T repulsion(const "
                                    "approach<T>&) const` (docs/reference/concepts.md)");
  } else if constexpr (!NormalLaw<L> || !detail::repels_exactly<L>) {
    static_assert(detail::never<L>, "repulsion must return the scalar type of its approach: write T, as `auto` may be "
                                    "an expression that refers to what is gone (docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_damping_law() {
  constexpr bool takes_stiffness = requires { typename detail::resistance_t<L, double>; };
  constexpr bool takes_elastic = requires { typename detail::resistance_beside_t<L, double>; };
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a damping law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!takes_stiffness && !takes_elastic) {
    static_assert(detail::never<L>,
                  "a damping law needs `template <Scalar T> T resistance(const approach<T>&, "
                  "const T& stiffness) const`, or `const elastic<T>&` in place of the stiffness, with "
                  "a last argument `contact_memory<T>&`, a nested template, if it remembers "
                  "(docs/reference/concepts.md)");
  } else if constexpr (!detail::resists_in_every_scalar<L>) {
    static_assert(detail::never<L>, "a damping law must take every scalar, not double alone, because contacts are "
                                    "evaluated in lanes of eight: write `template <Scalar T>` before `T resistance`, "
                                    "and before `prepare` if it has one (docs/reference/concepts.md)");
  } else if constexpr (!DampingLaw<L> || !detail::resists_exactly<L>) {
    static_assert(detail::never<L>, "resistance must return the scalar type of its approach: write T, as `auto` may be "
                                    "an expression that refers to what is gone (docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_friction_law() {
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a friction law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires { typename detail::traction_t<L, double>; }) {
    static_assert(detail::never<L>, "a friction law needs `template <Scalar T> Vec3<T> traction(const slip<T>&, "
                                    "const T& normal_force) const`, with a third argument `contact_memory<T>&`, a "
                                    "nested template, if it remembers (docs/reference/concepts.md)");
  } else if constexpr (!detail::rubs_in_every_scalar<L>) {
    static_assert(detail::never<L>, "a friction law must take every scalar, not double alone, because contacts are "
                                    "evaluated in lanes of eight: write `template <Scalar T>` before `Vec3<T> "
                                    "traction` (docs/reference/concepts.md)");
  } else if constexpr (!FrictionLaw<L> || !detail::rubs_exactly<L>) {
    static_assert(detail::never<L>, "traction must return a Vec3 of the scalar type of its slip: write Vec3<T> "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_capillary_law() {
  constexpr bool prepares = requires { typename detail::coefficients_in_t<L, double>; };
  constexpr bool attracts = requires { typename detail::simple_attraction_t<L, double>; };
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a capillary law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!CapillaryLaw<L> && prepares) {
    static_assert(detail::never<L>, "a capillary law with `prepare(bridge, fluid)` must return its nested template "
                                    "`coefficients<T>` from it and needs `template <Scalar T> T attraction(const T& "
                                    "gap, const coefficients<T>&) const` (docs/reference/concepts.md)");
  } else if constexpr (!CapillaryLaw<L> && !attracts) {
    static_assert(detail::never<L>, "a capillary law needs `template <Scalar T> T attraction(const bridge<T>&, const "
                                    "fluid&) const`, or `prepare` and `attraction(gap, coefficients)` "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::attracts_in_every_scalar<L>) {
    static_assert(detail::never<L>, "a capillary law must take every scalar, not double alone, because bridges are "
                                    "evaluated in lanes of eight: write `template <Scalar T>` before `T attraction`, "
                                    "and before `prepare` if it has one (docs/reference/concepts.md)");
  } else if constexpr (!CapillaryLaw<L> || !detail::attracts_exactly<L>) {
    static_assert(detail::never<L>, "attraction must return the scalar type of its bridge: write T, as `auto` may be "
                                    "an expression that refers to what is gone (docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_rupture_law() {
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a rupture law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires { typename detail::distance_t<L, double>; }) {
    static_assert(detail::never<L>, "a rupture law needs `template <Scalar T> T distance(const bridge<T>&, const "
                                    "fluid&) const` (docs/reference/concepts.md)");
  } else if constexpr (!detail::breaks_in_every_scalar<L>) {
    static_assert(detail::never<L>, "a rupture law must take every scalar, not double alone: write `template <Scalar "
                                    "T> T distance(const bridge<T>&, const fluid&) const` "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!RuptureLaw<L> || !detail::breaks_exactly<L>) {
    static_assert(detail::never<L>, "distance must return the scalar type of its bridge: write T, as `auto` may be an "
                                    "expression that refers to what is gone (docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_viscous_bridge_law() {
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a viscous bridge law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires { typename detail::bridge_resistance_t<L, double>; }) {
    static_assert(detail::never<L>, "a viscous bridge law needs `template <Scalar T> bridge_resistance<T> "
                                    "resistance(const bridge<T>&, const fluid&) const` (docs/reference/concepts.md)");
  } else if constexpr (!detail::drags_in_every_scalar<L>) {
    static_assert(detail::never<L>, "a viscous bridge law must take every scalar, not double alone, because bridges "
                                    "are evaluated in lanes of eight: write `template <Scalar T>` before "
                                    "`bridge_resistance<T> resistance` (docs/reference/concepts.md)");
  } else if constexpr (!ViscousBridgeLaw<L> || !detail::drags_exactly<L>) {
    static_assert(detail::never<L>, "resistance of a bridge must return a bridge_resistance of the scalar type of its "
                                    "bridge: write bridge_resistance<T> (docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_mean_radius() {
  if constexpr (!Copyable<L>) {
    static_assert(detail::never<L>, "a mean radius must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires { typename detail::mean_radius_t<L, double>; }) {
    static_assert(detail::never<L>, "a mean radius needs `template <Scalar T> T of(const bridge<T>&) const` "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::averages_in_every_scalar<L>) {
    static_assert(detail::never<L>,
                  "a mean radius must take every scalar, not double alone: write `template <Scalar T> "
                  "T of(const bridge<T>&) const` (docs/reference/concepts.md)");
  } else if constexpr (!MeanRadius<L> || !detail::averages_exactly<L>) {
    static_assert(detail::never<L>, "of must return the scalar type of its bridge: write T, as `auto` may be an "
                                    "expression that refers to what is gone (docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
inline constexpr bool normal_law = is_normal_law<L>();
template <class L>
inline constexpr bool damping_law = is_damping_law<L>();
template <class L>
inline constexpr bool friction_law = is_friction_law<L>();
template <class L>
inline constexpr bool capillary_law = is_capillary_law<L>();
template <class L>
inline constexpr bool rupture_law = is_rupture_law<L>();
template <class L>
inline constexpr bool mean_radius = is_mean_radius<L>();
template <class L>
inline constexpr bool viscous_bridge_law = is_viscous_bridge_law<L>();

}  // namespace pendular::check
