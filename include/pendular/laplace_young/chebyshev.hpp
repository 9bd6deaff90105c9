// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pendular::laplace_young::detail {

/// Nodes of Chebyshev's first kind on [-1, 1].
inline double chebyshev_node(int k, int count) { return std::cos(std::numbers::pi * (k + 0.5) / count); }

/// T_0(x) to T_{count-1}(x), in any scalar.
template <class T, std::size_t Count>
void chebyshev_basis(const T& x, std::array<T, Count>& out) {
  out[0] = T(1);
  if constexpr (Count > 1) out[1] = x;
  for (std::size_t k = 2; k < Count; ++k) out[k] = T(T(2) * x * out[k - 1] - out[k - 2]);
}

/// sum_k weights[k] basis[k]
template <class Weight, class T, std::size_t Count>
T weighted_sum(const Weight* weights, const std::array<T, Count>& basis) {
  T sum = T(T(weights[0]) * basis[0]);
  for (std::size_t k = 1; k < Count; ++k) sum = T(sum + T(weights[k]) * basis[k]);
  return sum;
}

/// Coefficients of the interpolant of values at the nodes, along the rows of a matrix whose columns are nodes.
inline Eigen::MatrixXd chebyshev_coefficients(const Eigen::MatrixXd& values) {
  const int count = static_cast<int>(values.cols());
  Eigen::MatrixXd basis(count, count);
  for (int n = 0; n < count; ++n) {
    for (int k = 0; k < count; ++k) {
      basis(n, k) = (k == 0 ? 1.0 : 2.0) / count * std::cos(k * std::numbers::pi * (n + 0.5) / count);
    }
  }
  return values * basis;
}

/// The polynomial sum_k c_k T_k(t) in powers of t.
inline Eigen::VectorXd chebyshev_to_powers(const Eigen::VectorXd& c) {
  const Eigen::Index count = c.size();
  Eigen::VectorXd before = Eigen::VectorXd::Zero(count), now = before, sum = before;
  before[0] = 1;
  if (count > 1) now[1] = 1;
  sum += c[0] * before;
  for (Eigen::Index k = 1; k < count; ++k) {
    sum += c[k] * now;
    Eigen::VectorXd next = -before;
    next.tail(count - 1) += 2 * now.head(count - 1);
    before = now;
    now = next;
  }
  return sum;
}

}  // namespace pendular::laplace_young::detail
