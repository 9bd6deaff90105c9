// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/samples.hpp>
#include <pendular/testing/scalars.hpp>

namespace pendular::testing {

namespace detail {
template <RuptureLaw Law>
void demand_distance(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const double here = law.distance(b, f);
  demand(broken, std::isfinite(here) && here > 0, "the rupture distance must be finite and positive",
         {{"volume", b.volume}, {"radius_j", b.radius_j}, {"distance", here}});
  const double dry = law.distance(bridge<double>{b.gap, 0.0, b.radius_i, b.radius_j}, f);
  demand(broken, dry == 0, "the rupture distance must be zero without liquid", {{"distance", dry}});
  const double wetter = law.distance(bridge<double>{b.gap, 1.1 * b.volume, b.radius_i, b.radius_j}, f);
  demand(broken, wetter > here, "the rupture distance must grow with the volume",
         {{"volume", b.volume}, {"distance", here}, {"with a tenth more", wetter}});
  const double elsewhere = law.distance(bridge<double>{b.gap + b.radius_i, b.volume, b.radius_i, b.radius_j}, f);
  demand(broken, agree(here, elsewhere, 1e-14), "the rupture distance must not depend on the gap",
         {{"gap", b.gap}, {"distance", here}, {"at a larger gap", elsewhere}});
}

template <RuptureLaw Law>
void demand_rupture_invariance(report& broken, const Law& law, const bridge<double>& b, const fluid& f) {
  const double here = law.distance(b, f);
  const double from_j = law.distance(bridge<double>{b.gap, b.volume, b.radius_j, b.radius_i}, f);
  demand(broken, agree(here, from_j, 1e-12), "the rupture distance must not change when i and j are exchanged",
         {{"radius_i", b.radius_i}, {"radius_j", b.radius_j}, {"distance", here}, {"exchanged", from_j}});
  for (const double k : {1e-2, 1e3}) {
    const bridge<double> similar{k * b.gap, k * k * k * b.volume, k * b.radius_i, k * b.radius_j};
    const double scaled = law.distance(similar, f);
    demand(broken, agree(scaled, k * here, 1e-12), "the rupture distance must scale as a length",
           {{"scale", k}, {"distance", here}, {"of the scaled bridge", scaled}});
  }
}

template <class T, RuptureLaw Law>
void demand_rupture_in(report& broken, const Law& law, const fluid& f, std::string_view property) {
  demand(broken, pendular::detail::Breaks<Law, T>, property, {});
  if constexpr (pendular::detail::Breaks<Law, T>) {
    const auto distance = [&](const auto& b) { return law.distance(b, f); };
    demand_same_in<T>(broken, property, bridge_samples(validity_of<Law>()), distance);
  }
}
}  // namespace detail

/// What a rupture law promises beyond its signature.
template <RuptureLaw Law>
report rupture_law_report(const Law& law, const fluid& f) {
  report broken;
  for (const bridge<double>& b : bridge_samples(validity_of<Law>())) {
    detail::demand_distance(broken, law, b, f);
    detail::demand_rupture_invariance(broken, law, b, f);
  }
  using lanes_of_float = lanes<16, float>;
  detail::demand_rupture_in<float>(broken, law, f, "the rupture distance must be the same in float");
  detail::demand_rupture_in<lanes<8>>(broken, law, f, "the rupture distance must be the same in lanes of double");
  detail::demand_rupture_in<lanes_of_float>(broken, law, f, "the rupture distance must be the same in lanes of float");
  detail::demand_rupture_in<dual>(broken, law, f,
                                  "the rupture distance must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
