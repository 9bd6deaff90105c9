// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/laplace_young/chebyshev.hpp>
#include <pendular/laplace_young/solve.hpp>

#include <Eigen/QR>

#include <array>
#include <cmath>
#include <limits>
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
/// polynomial. Its coefficients and D_r / V^{1/3} are Chebyshev polynomials in v^{1/12} and the contrast of the radii, and
/// for a sphere and a plane in v^{1/12} alone.
class force_table {
 public:
  static constexpr int terms = 8;                                     // of P
  static constexpr double least_volume = 1e-6, largest_volume = 0.3;  // v = V / (R_i R_j)^{3/2}, at a plane V / R^3
  static constexpr double largest_ratio = 10;
  static constexpr int volumes = 14, contrasts = 24;  // terms in volume and contrast

  explicit force_table(double contact_angle) : contact_angle_(contact_angle) {
    Eigen::MatrixXd pairs(terms + 1, volumes * contrasts), planes(terms + 1, volumes);
    for (int i = 0; i < volumes; ++i) {
      const double volume = std::pow(root_centre() + root_width() * detail::chebyshev_node(i, volumes), 12);
      for (int j = 0; j < contrasts; ++j) {
        const double ratio = ratio_of(0.5 * most_contrast() * (1 + detail::chebyshev_node(j, contrasts)));
        pairs.col(i * contrasts + j) = fit(volume * std::pow(ratio, 1.5), ratio);
      }
      planes.col(i) = fit(volume, std::numeric_limits<double>::infinity());
    }
    transform(pairs);
    const Eigen::MatrixXd at_planes = detail::chebyshev_coefficients(planes);
    for (int k = 0; k <= terms; ++k) {
      for (int i = 0; i < volumes; ++i) planes_.push_back(at_planes(k, i));
    }
  }

  double contact_angle() const { return contact_angle_; }

  /// What is known of one bridge: coefficients of the powers of t, then D_r / V^{1/3}; numbers First to `terms`, in any
  /// scalar.
  template <std::size_t First, class T>
  std::array<T, terms + 1 - First> evaluate(const T& volume_root, const T& contrast) const {
    std::array<T, volumes> in_volume;
    std::array<T, contrasts> in_contrast;
    detail::chebyshev_basis(T((volume_root - T(root_centre())) / T(root_width())), in_volume);
    detail::chebyshev_basis(T(T(2 / most_contrast()) * contrast - T(1)), in_contrast);
    std::array<T, (terms + 1 - First) * volumes> rows;  // summed over the contrast, all rows side by side
    rows.fill(T(T(0) * volume_root));
    for (std::size_t j = 0; j < in_contrast.size(); ++j) {
      const double* column = coefficients_.data() + (j * (terms + 1) + First) * volumes;
      for (std::size_t r = 0; r < rows.size(); ++r) rows[r] = T(rows[r] + T(column[r]) * in_contrast[j]);
    }
    std::array<T, terms + 1 - First> result;
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] = detail::weighted_sum(rows.data() + k * volumes, in_volume);
    }
    return result;
  }

  /// The same between a sphere and a plane.
  template <std::size_t First, class T>
  std::array<T, terms + 1 - First> at_plane(const T& volume_root) const {
    std::array<T, volumes> basis;
    detail::chebyshev_basis(T((volume_root - T(root_centre())) / T(root_width())), basis);
    std::array<T, terms + 1 - First> result;
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] = detail::weighted_sum(planes_.data() + (First + k) * basis.size(), basis);
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

  static double ratio_of(double contrast) {
    const double q = contrast * contrast * contrast;
    return (1 + q) / (1 - q);
  }

  /// One bridge at a sphere of radius 1: powers of t by weighted least squares over Chebyshev nodes, and the rupture
  /// distance.
  Eigen::VectorXd fit(double volume, double ratio) const {
    constexpr int samples = 40;
    const double harmonic = 2 / (1 / ratio + 1);
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
          coefficients_[static_cast<std::size_t>((j * (terms + 1) + k) * volumes + i)] = both(i, j);
        }
      }
    }
  }

  double contact_angle_;
  std::vector<double> coefficients_;  // [contrast][number][volume]
  std::vector<double> planes_;        // [number][volume]
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
