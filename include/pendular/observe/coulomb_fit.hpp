// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace pendular::observe {

/// Mohr-Coulomb line: shear stress = cohesion + tan_friction * normal stress.
struct coulomb_line {
  double cohesion = 0;        // Pa
  double tan_friction = 0;    // tangent of the angle of internal friction
  double cohesion_error = 0;  // standard errors, not a number for two points
  double tan_friction_error = 0;
  double scatter = 0;  // standard deviation of the shear stresses about the line, Pa

  double friction_angle() const { return std::atan(tan_friction); }  // rad
  double friction_angle_error() const { return tan_friction_error / (1 + tan_friction * tan_friction); }
};

/// The line through points of (normal stress, shear stress), Pa, by ordinary least squares; standard errors from the
/// scatter about it, with two degrees of freedom less than there are points.
/// Source: J. R. Taylor, An Introduction to Error Analysis (1997), section 8.4.
/// Errors: input_error for fewer than two points, spans of unequal length, or one normal stress only.
inline coulomb_line coulomb_fit(std::span<const double> normal_stress, std::span<const double> shear_stress) {
  constexpr auto page = "docs/reference/observe.md";
  const double n = static_cast<double>(normal_stress.size());
  expects(n >= 2, "the number of points of a Coulomb line", n, "at least 2", page);
  expects(normal_stress.size() == shear_stress.size(), "the number of shear stresses",
          static_cast<double>(shear_stress.size()), "that of the normal stresses", page);
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::Map<const Eigen::ArrayXd> x(normal_stress.data(), size), y(shear_stress.data(), size);
  const double mean = x.mean(), spread = (x - mean).square().sum();
  expects(spread > 0, "the spread of the normal stresses (Pa2)", spread, "above 0", page);
  coulomb_line line;
  line.tan_friction = ((x - mean) * y).sum() / spread;
  line.cohesion = y.mean() - line.tan_friction * mean;
  const double squares = (y - line.cohesion - line.tan_friction * x).square().sum();
  line.scatter = n > 2 ? std::sqrt(squares / (n - 2)) : std::numeric_limits<double>::quiet_NaN();
  line.tan_friction_error = line.scatter / std::sqrt(spread);
  line.cohesion_error = line.scatter * std::sqrt(1 / n + mean * mean / spread);
  return line;
}

}  // namespace pendular::observe
