// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/core/never.hpp>
#include <pendular/liquid/liquid.hpp>

#include <concepts>
#include <cstdint>
#include <string_view>
#include <utility>

namespace pendular::check {

// Ladders as those of laws (law/check.hpp): true, or one sentence for the first clause that is broken.

namespace detail {
using namespace pendular::detail;

template <class P>
using offer_t = decltype(std::declval<const P&>().offer(std::declval<const bond_side&>()));
template <class P>
concept Offers = requires {
  typename offer_t<P>;
};
template <class P>
concept Merges = requires(const P p, const offer_t<P> o) {
  { p.merge(o, o) } -> std::convertible_to<offer_t<P>>;
};
template <class P>
concept Settles = requires(const P p, const offer_t<P> o) {
  p.settle(p.merge(o, o), 1.0);
};
template <class P>
concept HasPeriod = requires(const P p) {
  { p.period } -> std::convertible_to<std::int64_t>;
};
}  // namespace detail

template <class F>
consteval bool is_formation_rule() {
  if constexpr (!Copyable<F>) {
    static_assert(detail::never<F>, "a formation rule must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires(const F f) {
                         { f.reach(1.0) } -> std::convertible_to<double>;
                       }) {
    static_assert(detail::never<F>,
                  "a formation rule needs `double reach(double rupture_distance) const`, the gap below "
                  "which a bridge forms (docs/reference/concepts.md)");
  } else if constexpr (!FormationRule<F>) {
    static_assert(detail::never<F>, "a formation rule needs a member `double minimum_volume`, the least V_b / R^3 "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class P>
consteval bool is_local_protocol() {
  if constexpr (!Copyable<P>) {
    static_assert(detail::never<P>, "a protocol must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::Offers<P>) {
    static_assert(detail::never<P>, "a local protocol needs `offer(const bond_side&) const`, what one bond of a grain "
                                    "says (docs/reference/concepts.md)");
  } else if constexpr (!detail::Merges<P>) {
    static_assert(detail::never<P>, "a local protocol needs `merge(a, b) const`, which makes one offer of two "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::Settles<P>) {
    static_assert(detail::never<P>,
                  "a local protocol needs `settle(offer, double film) const`, what a grain grants its "
                  "bonds (docs/reference/concepts.md)");
  } else if constexpr (!LocalProtocol<P>) {
    static_assert(detail::never<P>,
                  "a local protocol needs `double pull(const bond_side&, grant) const`, the volume for "
                  "one bond (docs/reference/concepts.md)");
  }
  return true;
}

template <class P>
consteval bool is_global_protocol() {
  if constexpr (!Copyable<P>) {
    static_assert(detail::never<P>, "a protocol must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::HasPeriod<P>) {
    static_assert(detail::never<P>, "a global protocol needs a member `std::int64_t period`, in steps "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!GlobalProtocol<P>) {
    static_assert(detail::never<P>,
                  "a global protocol needs `template <class Door> void redistribute(Door& door) const` "
                  "(docs/reference/concepts.md)");
  }
  return true;
}

template <class S>
consteval bool is_source() {
  if constexpr (!Copyable<S>) {
    static_assert(detail::never<S>, "a source must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::HasPeriod<S>) {
    static_assert(detail::never<S>, "a source needs a member `std::int64_t period`, in steps "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires(const S s) {
                         { s.account } -> std::convertible_to<std::string_view>;
                       }) {
    static_assert(detail::never<S>, "a source needs `static constexpr std::string_view account`, the name of what it "
                                    "gives to or takes from (docs/reference/concepts.md)");
  } else if constexpr (!Source<S>) {
    static_assert(detail::never<S>, "a source needs `template <class Door> void act(Door& door) const` "
                                    "(docs/reference/concepts.md)");
  }
  return true;
}

template <class F>
inline constexpr bool formation_rule = is_formation_rule<F>();
template <class P>
inline constexpr bool local_protocol = is_local_protocol<P>();
template <class P>
inline constexpr bool global_protocol = is_global_protocol<P>();
template <class S>
inline constexpr bool source = is_source<S>();

}  // namespace pendular::check
