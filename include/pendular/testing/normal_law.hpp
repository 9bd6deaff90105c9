// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/resistance.hpp>
#include <pendular/law/stiffness.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/samples.hpp>
#include <pendular/testing/scalars.hpp>

#include <vector>

namespace pendular::testing {

/// The push from a memory of zeros.
template <NormalLaw Law, class T>
T first_push(const Law& law, const approach<T>& a) {
  auto memory = fresh_memory<contact_memory_t<Law, T>, T>();
  return pendular::detail::ask_with<Law, T>([&](auto&... own) -> T { return law.repulsion(a, own...); }, memory);
}

namespace detail {
template <class L>
concept HasNormalEnergy = requires(const L law, const approach<double> a) {
  { law.energy(a) } -> std::convertible_to<double>;
};

inline approach<double> at_gap(approach<double> a, double gap) {
  a.gap = gap;
  return a;
}

template <NormalLaw Law>
void demand_push(report& broken, const Law& law, const approach<double>& a) {
  const double push = first_push(law, a);
  const std::initializer_list<quantity> example = {{"gap", a.gap}, {"repulsion", push}};
  demand(broken, std::isfinite(push), "the repulsion must be finite", example);
  demand(broken, !(push < 0), "the repulsion must not be negative", example);
  demand(broken, a.gap < 0 || push == 0, "the repulsion must be zero out of contact", example);
  const double deeper = first_push(law, at_gap(a, 1.1 * a.gap));
  demand(broken, a.gap >= 0 || deeper > push, "the repulsion must grow with the overlap",
         {{"gap", a.gap}, {"repulsion", push}, {"at 1.1 gap", deeper}});
  const double scraping = first_push(law, at_gap(a, -1e-9 * a.radius_i));
  const double pressed = first_push(law, at_gap(a, -1e-2 * a.radius_i));
  demand(broken, scraping < 1e-3 * pressed, "the repulsion must start from zero at first touch",
         {{"at 1e-9 radii", scraping}, {"at 1e-2 radii", pressed}});
}

template <NormalLaw Law>
void demand_symmetry(report& broken, const Law& law, const approach<double>& a) {
  const double push = first_push(law, a);
  const approach<double> swapped{a.gap, a.closing_speed, a.reduced_mass, a.radius_j, a.radius_i};
  const double from_j = first_push(law, swapped);
  demand(broken, agree(push, from_j, 1e-12), "the repulsion must not change when i and j are exchanged",
         {{"radius_i", a.radius_i}, {"radius_j", a.radius_j}, {"repulsion", push}, {"exchanged", from_j}});
}

template <NormalLaw Law>
  requires pendular::detail::Repels<Law, dual> || pendular::detail::KnowsStiffness<Law, double>
void demand_stiffness(report& broken, const Law& law, const approach<double>& a) {
  if (a.gap >= 0) return;
  const double step = 1e-4 * a.gap;
  const double rise = first_push(law, at_gap(a, a.gap + step)) - first_push(law, at_gap(a, a.gap - step));
  const double found = stiffness(law, a);
  demand(broken, agree(found, -rise / (2 * step), 1e-6), "the stiffness must be the slope of the repulsion",
         {{"gap", a.gap}, {"stiffness", found}, {"slope", -rise / (2 * step)}});
}

template <NormalLaw Law>
void demand_constant_stiffness(report& broken, const Law& law, const approach<double>& a) {
  if (a.gap >= 0) return;
  const double here = stiffness(law, a), deeper = stiffness(law, at_gap(a, 2 * a.gap));
  const approach<double> larger{a.gap, a.closing_speed, a.reduced_mass, 2 * a.radius_i, 2 * a.radius_j};
  const bool same = agree(here, deeper, 1e-12) && agree(here, stiffness(law, larger), 1e-12);
  demand(broken, same, "a stiffness said to be constant must depend neither on the overlap nor on the radii",
         {{"gap", a.gap}, {"stiffness", here}, {"at twice the overlap", deeper}});
}

template <NormalLaw Law>
  requires(pendular::detail::Remembers<Law, double>)
void demand_separation(report& broken, const Law& law, const approach<double>& a) {
  auto memory = fresh_memory<contact_memory_t<Law, double>, double>();
  law.repulsion(a, memory);
  law.repulsion(at_gap(a, std::abs(a.gap)), memory);
  demand(broken, is_zero(memory), "what a normal law remembers must be zero out of contact", {{"gap before", a.gap}});
}

template <HasNormalEnergy Law>
void demand_energy(report& broken, const Law& law, const approach<double>& a) {
  const auto push = [&](double overlap) { return double(first_push(law, at_gap(a, -overlap))); };
  const double work = a.gap < 0 ? integral(push, 0, -a.gap) : 0.0;
  const double found = law.energy(a);
  demand(broken, agree(found, work, 1e-5), "the energy must be the work of the repulsion",
         {{"gap", a.gap}, {"energy", found}, {"work", work}});
}

template <class T, NormalLaw Law>
void demand_normal_in(report& broken, const Law& law, std::string_view property) {
  demand(broken, pendular::detail::Repels<Law, T>, property, {});
  if constexpr (pendular::detail::Repels<Law, T>) {
    const auto push = [&](const auto& a) { return first_push(law, a); };
    demand_same_in<T>(broken, property, approach_samples(), push);
  }
}
}  // namespace detail

/// What a normal law promises beyond its signature.
template <NormalLaw Law>
report normal_law_report(const Law& law) {
  report broken;
  for (const approach<double>& a : approach_samples()) {
    detail::demand_push(broken, law, a);
    detail::demand_symmetry(broken, law, a);
    if constexpr (requires { detail::demand_stiffness(broken, law, a); }) detail::demand_stiffness(broken, law, a);
    if constexpr (requires { requires Law::has_constant_stiffness; }) {
      detail::demand_constant_stiffness(broken, law, a);
    }
    if constexpr (detail::HasNormalEnergy<Law>) detail::demand_energy(broken, law, a);
    if constexpr (pendular::detail::Remembers<Law, double>) detail::demand_separation(broken, law, a);
  }
  detail::demand_normal_in<float>(broken, law, "the repulsion must be the same in float");
  detail::demand_normal_in<lanes<8>>(broken, law, "the repulsion must be the same in lanes of double");
  detail::demand_normal_in<lanes<16, float>>(broken, law, "the repulsion must be the same in lanes of float");
  detail::demand_normal_in<dual>(broken, law, "the repulsion must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
