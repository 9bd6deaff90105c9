// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <cmath>
#include <type_traits>

namespace pendular::formation {

/// A bridge forms in the step in which its grains come to touch. A contact that closes dry stays dry until it has opened
/// and closes again.
struct at_contact {
  static constexpr bool needs_closing = true;
  double minimum_volume = 1e-6;  // V_b / R^3, R = sqrt(R_i R_j); below it the liquid stays on the grains

  /// Gap below which a bridge forms, m.
  constexpr double reach(double /*rupture_distance*/) const { return 0; }
};

/// A bridge forms as soon as it would not break at once.
struct within_rupture_distance {
  double minimum_volume = 1e-6;  // V_b / R^3, R = sqrt(R_i R_j); below it the liquid stays on the grains

  /// Gap below which a bridge forms, m.
  constexpr double reach(double rupture_distance) const { return rupture_distance; }
};

template <class Rule>
  requires(std::is_same_v<Rule, at_contact> || std::is_same_v<Rule, within_rupture_distance>)
void validate(const Rule& rule) {
  expects(rule.minimum_volume >= 0 && std::isfinite(rule.minimum_volume), "the minimum volume of a bridge over R^3",
          rule.minimum_volume, "at least 0 and finite", "docs/reference/liquid.md");
}

}  // namespace pendular::formation
