// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/liquid.hpp>
#include <pendular/testing/report.hpp>

#include <cmath>

namespace pendular::testing {

/// What a formation rule promises beyond its signature.
template <FormationRule F>
report formation_rule_report(const F& rule) {
  report broken;
  const double least = rule.minimum_volume;
  demand(broken, least >= 0 && std::isfinite(least), "the minimum volume must be at least 0 and finite",
         {{"minimum volume over R^3", least}});
  double before = -HUGE_VAL;
  for (const double distance : {0.0, 1e-9, 1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 1e-4, 1e-3, 1e-2, 1.0}) {
    const double reach = rule.reach(distance);
    const std::initializer_list<quantity> example = {{"rupture distance", distance}, {"reach", reach}};
    demand(broken, std::isfinite(reach), "the reach must be finite", example);
    demand(broken, reach <= distance, "the reach must not be above the rupture distance", example);
    demand(broken, reach >= before, "the reach must not fall with the rupture distance", example);
    before = reach;
  }
  return broken;
}

}  // namespace pendular::testing
