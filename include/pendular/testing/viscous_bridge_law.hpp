// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>
#include <pendular/law/validity.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/samples.hpp>
#include <pendular/testing/scalars.hpp>

#include <cmath>

namespace pendular::testing {

namespace detail {
template <ViscousBridgeLaw Law>
void demand_drag(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const bridge_resistance<double> here = law.resistance(b, f);
  const std::initializer_list<quantity> example = {
      {"gap", b.gap}, {"volume", b.volume}, {"normal", here.normal}, {"tangential", here.tangential}};
  demand(broken, std::isfinite(here.normal) && std::isfinite(here.tangential),
         "the resistance of a bridge must be finite", example);
  demand(broken, !(here.normal < 0) && !(here.tangential < 0), "the resistance of a bridge must not be negative",
         example);
  const bridge_resistance<double> dry = law.resistance(bridge<double>{b.gap, 0.0, b.radius_i, b.radius_j}, f);
  demand(broken, dry.normal == 0 && dry.tangential == 0, "the resistance of a bridge must be zero without liquid",
         {{"gap", b.gap}, {"normal", dry.normal}, {"tangential", dry.tangential}});
  const bridge_resistance<double> from_j = law.resistance(bridge<double>{b.gap, b.volume, b.radius_j, b.radius_i}, f);
  demand(broken, agree(here.normal, from_j.normal, 1e-12) && agree(here.tangential, from_j.tangential, 1e-12),
         "the resistance of a bridge must not change when i and j are exchanged",
         {{"radius_i", b.radius_i}, {"radius_j", b.radius_j}, {"normal", here.normal}, {"exchanged", from_j.normal}});
}

template <class T, ViscousBridgeLaw Law>
void demand_drag_in(report& broken, const Law& law, const fluid& f, std::string_view property) {
  demand(broken, pendular::detail::Drags<Law, T>, property, {});
  if constexpr (pendular::detail::Drags<Law, T>) {
    const auto normal = [&]<class U>(const bridge<U>& b) { return U(law.resistance(b, f).normal); };
    const auto tangential = [&]<class U>(const bridge<U>& b) { return U(law.resistance(b, f).tangential); };
    demand_same_in<T>(broken, property, bridge_samples(validity_of<Law>()), normal);
    demand_same_in<T>(broken, property, bridge_samples(validity_of<Law>()), tangential);
  }
}
}  // namespace detail

/// What a viscous bridge law promises beyond its signature.
template <ViscousBridgeLaw Law>
report viscous_bridge_law_report(const Law& law, const fluid& f) {
  report broken;
  for (const bridge<double>& b : bridge_samples(validity_of<Law>())) detail::demand_drag(broken, law, b, f);
  using lanes_of_float = lanes<16, float>;
  detail::demand_drag_in<float>(broken, law, f, "the resistance of a bridge must be the same in float");
  detail::demand_drag_in<lanes<8>>(broken, law, f, "the resistance of a bridge must be the same in lanes of double");
  detail::demand_drag_in<lanes_of_float>(broken, law, f,
                                         "the resistance of a bridge must be the same in lanes of float");
  detail::demand_drag_in<dual>(broken, law, f,
                               "the resistance of a bridge must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
