// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

namespace pendular::check {

// One sentence per broken clause: what is missing, what to write, where to read. Each ladder is true or stops the
// compilation at its first broken clause, so that `static_assert(check::capillary_law<my_law>)` says what to do.

namespace detail {
template <class L>
inline constexpr bool never = false;
}  // namespace detail

template <class L>
consteval bool is_normal_law() {
  if constexpr (!std::copyable<L>) {
    static_assert(detail::never<L>, "a normal law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires(const L law, const approach<double> a) { law.repulsion(a); }) {
    static_assert(detail::never<L>, "a normal law needs `template <Scalar T> T repulsion(const approach<T>&) const` "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!NormalLaw<L>) {
    static_assert(detail::never<L>, "repulsion must return the scalar type of its approach "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_damping_law() {
  if constexpr (!std::copyable<L>) {
    static_assert(detail::never<L>, "a damping law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires(const L law, const approach<double> a, const double k) { law.resistance(a, k); }) {
    static_assert(detail::never<L>, "a damping law needs `template <Scalar T> T resistance(const approach<T>&, "
                                    "const T& stiffness) const` (docs/reference/concepts.md)");
  } else if constexpr (!DampingLaw<L>) {
    static_assert(detail::never<L>, "resistance must return the scalar type of its approach "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_friction_law() {
  constexpr bool forgets = requires(const L law, const slip<double> s, const double n) { law.traction(s, n); };
  constexpr bool remembers =
      requires(const L law, const slip<double> s, const double n, contact_memory_t<L, double>& memory) {
    requires pendular::detail::Remembers<L, double>;
    law.traction(s, n, memory);
  };
  if constexpr (!std::copyable<L>) {
    static_assert(detail::never<L>, "a friction law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!forgets && !remembers) {
    static_assert(detail::never<L>, "a friction law needs `template <Scalar T> Vec3<T> traction(const slip<T>&, "
                                    "const T& normal_force) const`, with a third argument `contact_memory<T>&`, a "
                                    "nested template, if it remembers (docs/reference/concepts.md)");
  } else if constexpr (!FrictionLaw<L>) {
    static_assert(detail::never<L>, "traction must return a Vec3 of the scalar type of its slip "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_capillary_law() {
  constexpr bool prepares = requires(const L law, const bridge<double> b, const fluid f) { law.prepare(b, f); };
  constexpr bool attracts = requires(const L law, const bridge<double> b, const fluid f) { law.attraction(b, f); };
  if constexpr (!std::copyable<L>) {
    static_assert(detail::never<L>, "a capillary law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!CapillaryLaw<L> && prepares) {
    static_assert(detail::never<L>, "a capillary law with `prepare(bridge, fluid)` must return its nested template "
                                    "`coefficients<T>` from it and needs `template <Scalar T> T attraction(const T& "
                                    "gap, const coefficients<T>&) const` (docs/reference/concepts.md)");
  } else if constexpr (!CapillaryLaw<L> && attracts) {
    static_assert(detail::never<L>, "attraction must return the scalar type of its bridge "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!CapillaryLaw<L>) {
    static_assert(detail::never<L>, "a capillary law needs `template <Scalar T> T attraction(const bridge<T>&, const "
                                    "fluid&) const`, or `prepare` and `attraction(gap, coefficients)` "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class L>
consteval bool is_rupture_law() {
  if constexpr (!std::copyable<L>) {
    static_assert(detail::never<L>, "a rupture law must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires(const L law, const bridge<double> b, const fluid f) { law.distance(b, f); }) {
    static_assert(detail::never<L>, "a rupture law needs `template <Scalar T> T distance(const bridge<T>&, const "
                                    "fluid&) const` (docs/reference/concepts.md)");
  } else if constexpr (!RuptureLaw<L>) {
    static_assert(detail::never<L>, "distance must return the scalar type of its bridge "
                                    "(docs/reference/concepts.md)");
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

}  // namespace pendular::check
