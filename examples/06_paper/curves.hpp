// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run.hpp"

#include <string>
#include <vector>

namespace paper {

struct xy {
  std::vector<double> x, y;
};

/// Stress of a shear test over displacement in mean diameters, or of a compression over shortening in mean diameters,
/// averaged over a window of 0.05 diameters.
xy stress_curve(const run& r);

/// Mean of the curves of all seeds, where all of them have values.
xy mean_curve(const seeds& s);

/// Mean stress between two displacements, mean diameters.
double mean_between(const xy& curve, double from, double to);

/// Sudden stress drops: falls by more than `share` of the mean stress beyond one diameter, from one line of the curve to
/// the second after it, per mean diameter of displacement.
double drops_per_diameter(const run& r, double share);

}  // namespace paper
