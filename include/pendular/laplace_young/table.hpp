// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/chebyshev.hpp>
#include <pendular/laplace_young/solve.hpp>

#include <Eigen/QR>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <vector>

namespace pendular::laplace_young {

/// The stable bridges of all pairs and volumes at one contact angle, as polynomials.
///
/// The force of one bridge is F_D P(t), F_D = 2 pi gamma R_h cos(theta) (1 - D / sqrt(D^2 + 2 V / (pi R_h))),
/// t = 2 sqrt(1 - D/D_r) - 1: F_D takes the shape near contact, the square root the fold at rupture, and P is a
/// polynomial. Its coefficients and D_r / V^{1/3} are Chebyshev polynomials in v^{1/12} and the contrast of the radii.
class force_table {
 public:
  static constexpr int terms = 8;                                     // of P
  static constexpr double least_volume = 1e-6, largest_volume = 0.3;  // V / (R_i R_j)^{3/2}
  static constexpr double largest_ratio = 10;
  static constexpr int volumes = 14, contrasts = 24;  // terms in volume and contrast

  explicit force_table(double contact_angle) : contact_angle_(contact_angle) {
    Eigen::MatrixXd nodes(terms + 1, volumes * contrasts);
    for (int i = 0; i < volumes; ++i) {
      for (int j = 0; j < contrasts; ++j) nodes.col(i * contrasts + j) = fit(i, j);
    }
    transform(nodes);
  }

  double contact_angle() const { return contact_angle_; }

  /// Coefficients of the powers of t, and D_r / V^{1/3}, in any scalar.
  template <class T>
  std::array<T, terms + 1> evaluate(const T& volume_root, const T& contrast) const {
    std::array<T, volumes> in_volume;
    std::array<T, contrasts> in_contrast;
    detail::chebyshev_basis(T((volume_root - T(root_centre())) / T(root_width())), in_volume);
    detail::chebyshev_basis(T(T(2 / most_contrast()) * contrast - T(1)), in_contrast);
    std::array<T, terms + 1> result;
    for (int k = 0; k <= terms; ++k) {
      const auto row = static_cast<std::size_t>(k);
      T sum(T(0) * volume_root);
      for (std::size_t i = 0; i < std::size_t{volumes}; ++i) {
        T inner(T(0) * volume_root);
        const std::size_t first = (row * std::size_t{volumes} + i) * std::size_t{contrasts};
        for (std::size_t j = 0; j < std::size_t{contrasts}; ++j) {
          inner = T(inner + T(coefficients_[first + j]) * in_contrast[j]);
        }
        sum = T(sum + inner * in_volume[i]);
      }
      result[row] = sum;
    }
    return result;
  }

  // What the polynomials are in: v^{1/12}, and the cube root of (R_i - R_j)/(R_i + R_j), of which the rupture of nearly
  // equal spheres is a smooth function where it comes by the antisymmetric mode.
  static double root_least() { return std::pow(least_volume, 1.0 / 12); }
  static double root_largest() { return std::pow(largest_volume, 1.0 / 12); }
  static double most_contrast() { return std::cbrt((largest_ratio - 1) / (largest_ratio + 1)); }

 private:
  static double root_centre() { return 0.5 * (root_largest() + root_least()); }
  static double root_width() { return 0.5 * (root_largest() - root_least()); }

  /// One bridge: powers of t by weighted least squares over Chebyshev nodes, and the rupture distance.
  Eigen::VectorXd fit(int volume_node, int contrast_node) const {
    constexpr int samples = 40;
    const double root = root_centre() + root_width() * detail::chebyshev_node(volume_node, volumes);
    const double c = 0.5 * most_contrast() * (1 + detail::chebyshev_node(contrast_node, contrasts));
    const double q = c * c * c, ratio = (1 + q) / (1 - q);
    const double volume = std::pow(root, 12) * std::pow(ratio, 1.5), harmonic = 2 * ratio / (1 + ratio);
    bridges_of_volume bridges({1, ratio, contact_angle_, volume, 1 / (2 * std::numbers::pi)});
    const double farthest = bridges.rupture_distance();
    Eigen::MatrixXd basis(samples, terms);
    Eigen::VectorXd force(samples);
    for (int n = 0; n < samples; ++n) {
      const double t = std::cos(std::numbers::pi * n / (samples - 1)), s = 0.5 * (1 + t);
      const double gap = std::max((1 - s * s) * farthest, 0.0);
      const double area = 2 * volume / (std::numbers::pi * harmonic);
      const double scale = std::cos(contact_angle_) * (1 - gap / std::sqrt(gap * gap + area));
      std::array<double, terms> values;
      detail::chebyshev_basis(t, values);
      for (int k = 0; k < terms; ++k) basis(n, k) = scale * values[static_cast<std::size_t>(k)];
      force[n] = bridges.at(std::min(gap, farthest))->attraction / harmonic;
    }
    Eigen::VectorXd result(terms + 1);
    result.head(terms) = detail::chebyshev_to_powers(basis.colPivHouseholderQr().solve(force));
    result[terms] = farthest / std::cbrt(volume);
    return result;
  }

  /// From values at the nodes to coefficients, in both directions.
  void transform(const Eigen::MatrixXd& nodes) {
    coefficients_.resize(static_cast<std::size_t>(nodes.size()));
    for (int k = 0; k <= terms; ++k) {
      const Eigen::VectorXd row = nodes.row(k).transpose();
      const Eigen::MatrixXd values = row.reshaped(contrasts, volumes).transpose();
      const Eigen::MatrixXd once = detail::chebyshev_coefficients(values);
      const Eigen::MatrixXd both = detail::chebyshev_coefficients(once.transpose()).transpose();
      for (int i = 0; i < volumes; ++i) {
        for (int j = 0; j < contrasts; ++j) {
          coefficients_[static_cast<std::size_t>((k * volumes + i) * contrasts + j)] = both(i, j);
        }
      }
    }
  }

  double contact_angle_;
  std::vector<double> coefficients_;  // [number][volume][contrast]
};

/// The table of a contact angle, built once per program. Takes part of a second.
inline std::shared_ptr<const force_table> table_of(double contact_angle) {
  static std::mutex guard;
  static std::map<double, std::shared_ptr<const force_table>> built;
  const std::scoped_lock lock(guard);
  auto& table = built[contact_angle];
  if (!table) table = std::make_shared<const force_table>(contact_angle);
  return table;
}

}  // namespace pendular::laplace_young
