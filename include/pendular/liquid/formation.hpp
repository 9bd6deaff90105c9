// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pendular::formation {

/// A bridge forms when the grains touch.
struct at_contact {
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

}  // namespace pendular::formation
