// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/resistance.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/samples.hpp>
#include <pendular/testing/scalars.hpp>

#include <algorithm>
#include <cmath>

namespace pendular::testing {

/// The push of a law in whichever form it has, beside a linear spring, from a memory of zeros.
template <DampingLaw Law, class T>
T first_resistance(const Law& law, const approach<T>& a, const T& stiffness) {
  auto memory = fresh_memory<contact_memory_t<Law, T>, T>();
  return resistance(law, a, elastic<T>{T(stiffness * max(T(-a.gap), T(0))), stiffness}, memory);
}

namespace detail {
template <DampingLaw Law>
void demand_dissipation(report& broken, const Law& law, const approach<double>& a, double stiffness) {
  const double force = first_resistance(law, a, stiffness);
  const std::initializer_list<quantity> example = {
      {"gap", a.gap}, {"closing_speed", a.closing_speed}, {"stiffness", stiffness}, {"resistance", force}};
  demand(broken, std::isfinite(force), "the resistance must be finite", example);
  demand(broken, !(force * a.closing_speed < 0), "the resistance must dissipate", example);
  demand(broken, a.gap < 0 || force == 0, "the resistance must be zero out of contact", example);
  demand(broken, a.closing_speed != 0 || force == 0, "the resistance must be zero at zero speed", example);
}

template <DampingLaw Law>
void demand_damping_symmetry(report& broken, const Law& law, const approach<double>& a, double stiffness) {
  const double force = first_resistance(law, a, stiffness);
  const approach<double> swapped{a.gap, a.closing_speed, a.reduced_mass, a.radius_j, a.radius_i};
  const double from_j = first_resistance(law, swapped, stiffness);
  demand(broken, agree(force, from_j, 1e-12), "the resistance must not change when i and j are exchanged",
         {{"radius_i", a.radius_i}, {"radius_j", a.radius_j}, {"resistance", force}, {"exchanged", from_j}});
}

template <DampingLaw Law>
  requires(pendular::detail::PreparesDashpot<Law>)
void demand_preparation(report& broken, const Law& law, const approach<double>& a, double stiffness) {
  const double whole = first_resistance(law, a, stiffness);
  auto memory = fresh_memory<contact_memory_t<Law, double>, double>();
  const auto ask = [&](auto&... own) { return law.resistance(a, law.prepare(a.reduced_mass, stiffness), own...); };
  const double prepared = pendular::detail::ask_with<Law, double>(ask, memory);
  demand(broken, agree(whole, prepared, 1e-12), "the prepared resistance must be that from the stiffness",
         {{"gap", a.gap}, {"closing_speed", a.closing_speed}, {"resistance", whole}, {"prepared", prepared}});
}

template <DampingLaw Law>
  requires(pendular::detail::Remembers<Law, double>)
void demand_parting(report& broken, const Law& law, const approach<double>& a) {
  auto memory = fresh_memory<contact_memory_t<Law, double>, double>();
  for (const double gap : {a.gap, std::abs(a.gap)}) {
    approach<double> now = a;
    now.gap = gap;
    resistance(law, now, elastic<double>{1e3 * std::max(-gap, 0.0), 1e3}, memory);
  }
  demand(broken, is_zero(memory), "what a damping law remembers must be zero out of contact", {{"gap before", a.gap}});
}

template <class T, DampingLaw Law>
void demand_damping_in(report& broken, const Law& law, std::string_view property) {
  constexpr bool resists = pendular::detail::Resists<Law, T> || pendular::detail::ResistsBeside<Law, T>;
  demand(broken, resists, property, {});
  if constexpr (resists) {
    const auto force = [&]<class U>(const approach<U>& a) { return first_resistance(law, a, U(1e3)); };
    demand_same_in<T>(broken, property, approach_samples(), force);
  }
}
}  // namespace detail

/// What a damping law promises beyond its signature.
template <DampingLaw Law>
report damping_law_report(const Law& law) {
  report broken;
  for (const approach<double>& a : approach_samples()) {
    for (const double stiffness : {0.0, 1e-3, 1e3, 1e9}) {
      detail::demand_dissipation(broken, law, a, stiffness);
      detail::demand_damping_symmetry(broken, law, a, stiffness);
      if constexpr (pendular::detail::PreparesDashpot<Law>) detail::demand_preparation(broken, law, a, stiffness);
    }
    if constexpr (pendular::detail::Remembers<Law, double>) detail::demand_parting(broken, law, a);
  }
  detail::demand_damping_in<float>(broken, law, "the resistance must be the same in float");
  detail::demand_damping_in<lanes<8>>(broken, law, "the resistance must be the same in lanes of double");
  detail::demand_damping_in<lanes<16, float>>(broken, law, "the resistance must be the same in lanes of float");
  detail::demand_damping_in<dual>(broken, law, "the resistance must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
