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
template <MeanRadius Mean>
void demand_mean(report& broken, const Mean& mean, const bridge<double>& b) {
  const double here = mean.of(b);
  const double smaller = min(b.radius_i, b.radius_j), larger = max(b.radius_i, b.radius_j);
  demand(broken, here >= smaller * (1 - 1e-12) && here <= larger * (1 + 1e-12),
         "the mean radius must lie between the two radii", {{"smaller", smaller}, {"larger", larger}, {"mean", here}});
  const double from_j = mean.of(bridge<double>{b.gap, b.volume, b.radius_j, b.radius_i});
  demand(broken, agree(here, from_j, 1e-12), "the mean radius must not change when i and j are exchanged",
         {{"radius_i", b.radius_i}, {"radius_j", b.radius_j}, {"mean", here}, {"exchanged", from_j}});
  const double elsewhere = mean.of(bridge<double>{b.gap + b.radius_i, b.volume, b.radius_i, b.radius_j});
  demand(broken, agree(here, elsewhere, 1e-14), "the mean radius must not depend on the gap",
         {{"gap", b.gap}, {"mean", here}, {"at a larger gap", elsewhere}});
  for (const double k : {1e-2, 1e3}) {
    const double scaled = mean.of(bridge<double>{k * b.gap, k * k * k * b.volume, k * b.radius_i, k * b.radius_j});
    demand(broken, agree(scaled, k * here, 1e-12), "the mean radius must scale as a length",
           {{"scale", k}, {"mean", here}, {"of the scaled bridge over it", scaled / k}});
  }
}

template <class T, MeanRadius Mean>
void demand_mean_in(report& broken, const Mean& mean, std::string_view property) {
  demand(broken, pendular::detail::Averages<Mean, T>, property, {});
  if constexpr (pendular::detail::Averages<Mean, T>) {
    const auto of = [&]<class U>(const bridge<U>& b) { return U(mean.of(b)); };
    demand_same_in<T>(broken, property, bridge_samples(validity_of<Mean>()), of);
  }
}
}  // namespace detail

/// What a mean radius promises beyond its signature.
template <MeanRadius Mean>
report mean_radius_report(const Mean& mean) {
  report broken;
  for (const bridge<double>& b : bridge_samples(validity_of<Mean>())) detail::demand_mean(broken, mean, b);
  detail::demand_mean_in<float>(broken, mean, "the mean radius must be the same in float");
  detail::demand_mean_in<lanes<8>>(broken, mean, "the mean radius must be the same in lanes of double");
  detail::demand_mean_in<lanes<16, float>>(broken, mean, "the mean radius must be the same in lanes of float");
  detail::demand_mean_in<dual>(broken, mean, "the mean radius must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
