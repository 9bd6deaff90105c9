// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run.hpp"

#include <vector>

namespace paper {

struct xy {
  std::vector<double> x, y;
};

/// Stress over displacement in mean diameters of a shear test, or over shortening of a compression, averaged over a window
/// of 0.05 diameters. Shortening counts from where the lid bears a twentieth of the largest stress: before, it touches
/// single grains that stand out.
xy stress_curve(const run& r);

/// Mean of the curves of all seeds, where all of them have values.
xy mean_curve(const seeds& s);

/// Mean stress between two displacements, mean diameters. Errors: std::runtime_error if the curve does not cover them.
double mean_between(const xy& curve, double from, double to);

/// Largest stress of a curve and where, mean diameters, beyond the first 0.05: a sample that was not relaxed springs back
/// against the lid.
struct summit {
  double at, stress;
  bool rising;  // it is in the last 0.1 diameters of the curve: a lower bound
};
/// Errors: std::runtime_error if the curve is shorter than 0.05 diameters.
summit summit_of(const xy& curve);

/// The same over the residual stress, the mean from one to two diameters: 1 for a curve without a peak.
double summit_over_residual(const run& r);
/// Mean stress from 0.4 to 0.8 diameters, where dense samples have their peak, over the residual stress. Unlike the summit it
/// does not grow with the scatter of the curve: 1 or less says that there is no peak.
double early_over_residual(const run& r);

/// Means of a shear test over a stretch of displacement.
struct shear_state {
  double shear;    // stress on the plane between the halves, Pa
  double normal;   // stress on the same plane, from lid, weight and rims, Pa
  double bridges;  // per grain
  double height;   // of the lid, m
  double shared;   // area of the halves over that of the cell
};

/// Between two displacements, mean diameters. Errors: std::runtime_error if the curve has nothing there.
shear_state state_between(const run& r, double from, double to);
/// From one to two diameters, where the paper's samples are in their residual state.
shear_state residual_state(const run& r);
/// The same over the normal stress of the paper, N/S + rho g h (section 3.1.1): lid and weight, without what the rims of the
/// halves bear.
shear_state residual_state_over_lid_and_weight(const run& r);
/// About the largest shear stress: its own value, the rest within 0.1 diameters.
shear_state peak_state(const run& r);

/// Falls of the stress by more than `least` Pa from one line of the curve to the next ones, beyond one diameter, per mean
/// diameter of displacement; as long as the stress falls it is one. Errors: std::runtime_error if the curve ends before.
double falls_per_diameter(const run& r, double least);

}  // namespace paper
