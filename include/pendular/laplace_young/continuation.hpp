// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/equations.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace pendular::laplace_young::detail {

/// What is held while a bridge is pulled: its volume or its suction.
enum class held { volume, suction };

/// A solution and the direction in which the branch goes on from it.
struct point {
  vector6 z;
  vector6 ahead;       // unit tangent
  double singularity;  // of the problem at fixed gap; changes sign where the bridge loses its stability
};

/// Bridges of one pair by Newton's method, with all six numbers unknown and one condition more than the four equations
/// and what is held: a gap, a volume or a step along the branch.
class corrector {
 public:
  corrector(const geometry<double>& g, held h) : geometry_(g), held_(h) {}

  /// Condition row * z = value added to the equations.
  struct condition {
    vector6 row;
    double value;
  };

  static condition at(place p, double value) {
    vector6 row = vector6::Zero();
    row[p] = 1;
    return {row, value};
  }

  /// The solution near `start` that meets the condition; `held_value` is log volume or suction.
  std::optional<vector6> solve(vector6 z, double held_value, const condition& extra) const {
    double last = 1e300;
    for (int iteration = 0; iteration < 14; ++iteration) {
      linearised l = linearise(geometry_, z);
      keep_symmetry(l, z);
      const matrix6 m = matrix(l, z, extra.row);
      vector6 r;
      r << l.residual, hold(z) - held_value, extra.row.dot(z) - extra.value;
      vector6 step = m.partialPivLu().solve(-r);
      const double size = step.cwiseAbs().maxCoeff();
      if (!(size < 1e8)) return std::nullopt;
      if (size > 0.7) step *= 0.7 / size;
      z += step;
      if (size < 2e-14 || (size < 1e-10 && size > 0.3 * last)) return plausible(z) ? std::optional(z) : std::nullopt;
      last = size;
    }
    return std::nullopt;
  }

  /// Tangent in the sense of `sense`, and how near the problem at fixed gap is to being singular.
  point with_tangent(const vector6& z, const condition& sense) const {
    linearised l = linearise(geometry_, z);
    const double singularity = matrix(l, z, at(gap, 0).row).determinant();
    keep_symmetry(l, z);
    vector6 e = vector6::Zero();
    e[places - 1] = 1;
    const vector6 ahead = matrix(l, z, sense.row).partialPivLu().solve(e);
    return {z, ahead.normalized(), singularity};
  }

  double hold(const vector6& z) const {
    return held_ == held::volume ? z[log_volume] : z[turn] * std::exp(-z[log_length]);
  }

 private:
  matrix6 matrix(const linearised& l, const vector6& z, const vector6& extra) const {
    matrix6 m = matrix6::Zero();
    m.topRows<4>() = l.slope;
    if (held_ == held::volume) {
      m(4, log_volume) = 1;
    } else {
      m(4, turn) = std::exp(-z[log_length]);
      m(4, log_length) = -z[turn] * std::exp(-z[log_length]);
    }
    m.row(5) = extra;
    return m;
  }

  /// Between equal bodies the symmetric bridge is followed, also where an asymmetric one branches off: a meridian that
  /// is as far from the axis at both ends meets both under the same angle, so one equation is free to say so.
  void keep_symmetry(linearised& l, const vector6& z) const {
    if (geometry_.curvature_i != geometry_.curvature_j) return;
    l.residual[1] = z[log_arc_i] - z[log_arc_j];
    l.slope.row(1).setZero();
    l.slope(1, log_arc_i) = 1;
    l.slope(1, log_arc_j) = -1;
  }

  bool plausible(const vector6& z) const {
    const double most = boost::math::constants::pi<double>() - geometry_.contact_angle;
    return z.allFinite() && std::exp(z[log_arc_i]) * geometry_.curvature_i < most &&
           std::exp(z[log_arc_j]) * geometry_.curvature_j < most;
  }

  geometry<double> geometry_;
  held held_;
};

}  // namespace pendular::laplace_young::detail
