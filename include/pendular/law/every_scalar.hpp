// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>
#include <pendular/law/concepts.hpp>
#include <pendular/law/stiffness.hpp>

// Whether a law that models its concept, which asks in double, can be asked in every scalar and answers in it.
namespace pendular::detail {

/// Whether `holds.operator()<T>()` for numbers, for what the hot loop hands to laws and for what derivatives do.
template <class Holds>
consteval bool in_every_scalar(Holds holds) {
  return holds.template operator()<double>() && holds.template operator()<float>() &&
         holds.template operator()<block>() && holds.template operator()<dual>();
}

template <template <class, class> class Answer, class L>
consteval bool answers_in_every_scalar() {
  return in_every_scalar([]<class T>() {
    return requires { typename Answer<L, T>; };
  });
}

/// Exactly, because what merely converts to a T may be an expression that refers to what is gone.
template <template <class, class> class Answer, template <class> class Wanted, class L>
consteval bool answers_exactly() {
  return in_every_scalar([]<class T>() {
    if constexpr (requires { typename Answer<L, T>; }) {
      return std::is_same_v<Answer<L, T>, Wanted<T>>;
    } else {
      return true;  // another clause
    }
  });
}

template <class T>
using itself = T;

template <class L>
inline constexpr bool repels_in_every_scalar = answers_in_every_scalar<repulsion_t, L>();
template <class L>
inline constexpr bool repels_exactly = answers_exactly<repulsion_t, itself, L>();

/// Of the form that the library takes: from the stiffness where a law has that.
template <class L>
consteval bool is_resistant_in_every_scalar() {
  if constexpr (ResistsBeside<L, double>) {
    return answers_in_every_scalar<resistance_beside_t, L>();
  } else {
    return answers_in_every_scalar<resistance_t, L>();
  }
}
template <class L>
inline constexpr bool resists_in_every_scalar = is_resistant_in_every_scalar<L>() &&
                                                (!PreparesDashpot<L> ||
                                                 answers_in_every_scalar<prepared_resistance_t, L>());
template <class L>
inline constexpr bool resists_exactly = answers_exactly<resistance_t, itself, L>() &&
                                        (!ResistsBeside<L, double> ||
                                         answers_exactly<resistance_beside_t, itself, L>()) &&
                                        (!PreparesDashpot<L> || (answers_exactly<dashpot_t, prepared_dashpot, L>() &&
                                                                 answers_exactly<prepared_resistance_t, itself, L>()));

template <class L>
inline constexpr bool rubs_in_every_scalar = answers_in_every_scalar<traction_t, L>();
template <class L>
inline constexpr bool rubs_exactly = answers_exactly<traction_t, Vec3, L>();

/// Of the form that the library takes, which is the prepared one where a law has both.
template <class L>
consteval bool is_attractive_in_every_scalar() {
  if constexpr (Prepares<L, double>) {
    return in_every_scalar([]<class T>() { return Prepares<L, T>; });
  } else {
    return answers_in_every_scalar<simple_attraction_t, L>();
  }
}
template <class L>
inline constexpr bool attracts_in_every_scalar = is_attractive_in_every_scalar<L>();
template <class L>
inline constexpr bool attracts_exactly = answers_exactly<simple_attraction_t, itself, L>() &&
                                         (!Prepares<L, double> || answers_exactly<prepared_attraction_t, itself, L>());

template <class L>
inline constexpr bool breaks_in_every_scalar = answers_in_every_scalar<distance_t, L>();
template <class L>
inline constexpr bool breaks_exactly = answers_exactly<distance_t, itself, L>();

template <class L>
inline constexpr bool averages_in_every_scalar = answers_in_every_scalar<mean_radius_t, L>();
template <class L>
inline constexpr bool averages_exactly = answers_exactly<mean_radius_t, itself, L>();

template <class L>
inline constexpr bool drags_in_every_scalar = answers_in_every_scalar<bridge_resistance_t, L>();
template <class L>
inline constexpr bool drags_exactly = answers_exactly<bridge_resistance_t, bridge_resistance, L>();

}  // namespace pendular::detail
