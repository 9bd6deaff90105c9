// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>
#include <pendular/law/prepared.hpp>
#include <pendular/law/validity.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/samples.hpp>
#include <pendular/testing/scalars.hpp>

#include <cmath>
#include <limits>

namespace pendular::testing {

namespace detail {
template <class L, class T>
concept Pulls = pendular::detail::Attracts<L, T> || pendular::detail::Prepares<L, T>;

inline bridge<double> at_gap(bridge<double> b, double gap) {
  b.gap = gap;
  return b;
}
}  // namespace detail

/// The pull of a law in either of its two forms.
template <class Law, class T>
  requires detail::Pulls<Law, T> T pull(const Law& law, const bridge<T>& b, const fluid& f) {
    if constexpr (pendular::detail::Attracts<Law, T>) {
      return law.attraction(b, f);
    } else {
      return law.attraction(b.gap, law.prepare(b, f));
    }
  }

namespace detail {
/// What rounding leaves of a pull that goes to 0 at some gap: a share of the same bridge's pull at contact.
template <class T = double, CapillaryLaw Law>
double rounding(const Law& law, const bridge<double>& b, const fluid& f) {
  const double touch = pull(law, at_gap(b, 0), f);
  const double epsilon = std::numeric_limits<element_t<T>>::epsilon();
  return std::isfinite(touch) ? 32 * epsilon * std::abs(touch) : 0;
}

template <CapillaryLaw Law>
void demand_pull(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const double here = pull(law, b, f);
  const std::initializer_list<quantity> example = {
      {"gap", b.gap}, {"volume", b.volume}, {"radius_i", b.radius_i}, {"radius_j", b.radius_j}, {"attraction", here}};
  demand(broken, std::isfinite(here), "the attraction must be finite", example);
  demand(broken, !(here < 0), "the attraction must not be negative", example);
  for (const double volume : {0.0, 1e-30 * b.volume, 1e-12 * b.volume}) {
    const double drying = pull(law, bridge<double>{b.gap, volume, b.radius_i, b.radius_j}, f);
    demand(broken, std::isfinite(drying) && !(drying < 0), "the attraction must stay finite as the volume vanishes",
           {{"gap", b.gap}, {"volume", volume}, {"attraction", drying}});
  }
}

template <CapillaryLaw Law>
void demand_shape(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const double hair = 1e-12 * b.radius_i;
  const double touch = pull(law, at_gap(b, 0), f);
  const double inside = pull(law, at_gap(b, -hair), f);
  const double outside = pull(law, at_gap(b, hair), f);
  demand(broken, agree(inside, outside, 1e-6) && agree(inside, touch, 1e-6),
         "the attraction must be the same from both sides of first touch",
         {{"volume", b.volume}, {"inside", inside}, {"touching", touch}, {"outside", outside}});
  const double here = pull(law, b, f);
  const double further = pull(law, at_gap(b, b.gap + 1e-2 * std::cbrt(b.volume)), f);
  demand(broken, further <= here * (1 + 1e-12) + rounding(law, b, f), "the attraction must not grow with the gap",
         {{"gap", b.gap}, {"volume", b.volume}, {"attraction", here}, {"further", further}});
}

template <CapillaryLaw Law>
void demand_invariance(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const double here = pull(law, b, f);
  const double from_j = pull(law, bridge<double>{b.gap, b.volume, b.radius_j, b.radius_i}, f);
  demand(broken, agree(here, from_j, 1e-12, rounding(law, b, f)),
         "the attraction must not change when i and j are exchanged",
         {{"radius_i", b.radius_i}, {"radius_j", b.radius_j}, {"attraction", here}, {"exchanged", from_j}});
  for (const double k : {1e-2, 1e3}) {
    const bridge<double> similar{k * b.gap, k * k * k * b.volume, k * b.radius_i, k * b.radius_j};
    const double scaled = pull(law, similar, f);
    demand(broken, agree(scaled, k * here, 1e-10, k * rounding(law, b, f)), "the attraction must scale as a length",
           {{"scale", k}, {"attraction", here}, {"of the scaled bridge over it", scaled / k}});
  }
}

template <CapillaryLaw Law>
void demand_one_pull(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  if constexpr (pendular::detail::Attracts<Law, double> && pendular::detail::Prepares<Law, double>) {
    const double simple = law.attraction(b, f);
    const double prepared = law.attraction(b.gap, law.prepare(b, f));
    demand(broken, agree(simple, prepared, 1e-12, rounding(law, b, f)),
           "the simple and the prepared attraction must be the same",
           {{"gap", b.gap}, {"simple", simple}, {"prepared", prepared}});
  }
}

template <HasCapillaryEnergy Law>
void demand_work(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const double rupture = std::cbrt(b.volume);
  const auto force = [&](double gap) { return pull(law, at_gap(b, gap), f); };
  const double overlapping = b.gap < 0 ? integral(force, b.gap, 0) : 0.0;
  const double open = b.gap < rupture ? integral(force, std::max(b.gap, 0.0), rupture) : 0.0;
  const double found = law.energy(b, f, rupture);
  demand(broken, agree(found, overlapping + open, 1e-6, 1e-12 * force(0) * rupture),
         "the energy must be the work of the attraction up to rupture",
         {{"gap", b.gap}, {"volume", b.volume}, {"energy", found}, {"work", overlapping + open}});
}

template <class T, CapillaryLaw Law>
void demand_capillary_in(report& broken, const Law& law, const fluid& f, std::string_view property) {
  demand(broken, Pulls<Law, T>, property, {});
  if constexpr (Pulls<Law, T>) {
    const auto force = [&]<class U>(const bridge<U>& b) { return pull(law, b, f); };
    demand_same_in<T>(broken, property, bridge_samples(validity_of<Law>()), force, granted_error_of<T, Law>(),
                      [&](const bridge<double>& b) { return rounding<T>(law, b, f); });
  }
}
}  // namespace detail

/// What a capillary law promises beyond its signature; the shape over the gap only where the law says it is valid.
template <CapillaryLaw Law>
report capillary_law_report(const Law& law, const fluid& f) {
  report broken;
  for (const bridge<double>& b : bridge_samples(validity_of<Law>())) {
    detail::demand_pull(broken, law, b, f);
    if (validity_of<Law>().covers(b, f)) detail::demand_shape(broken, law, b, f);
    detail::demand_invariance(broken, law, b, f);
    detail::demand_one_pull(broken, law, b, f);
    if constexpr (HasCapillaryEnergy<Law>) detail::demand_work(broken, law, b, f);
  }
  using lanes_of_float = lanes<16, float>;
  detail::demand_capillary_in<float>(broken, law, f, "the attraction must be the same in float");
  detail::demand_capillary_in<lanes<8>>(broken, law, f, "the attraction must be the same in lanes of double");
  detail::demand_capillary_in<lanes_of_float>(broken, law, f, "the attraction must be the same in lanes of float");
  detail::demand_capillary_in<dual>(broken, law, f, "the attraction must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
