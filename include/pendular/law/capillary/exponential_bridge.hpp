// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::capillary {

/// What the laws of Richefeu et al. 2007 prepare per bond: the pull is amplitude * exp(-gap decay_rate).
template <class T>
struct exponential_bridge {
  T amplitude;   // kappa R, N
  T decay_rate;  // 1/lambda, 1/m

  /// Pull, N: the amplitude in overlap, decaying over the gap (Eq. 10).
  T attraction(const T& gap) const { return amplitude * exp(T(-max(gap, T(0)) * decay_rate)); }

  /// Work from the gap to the rupture distance, J: the integral of Eq. 10.
  T work(const T& gap, const T& rupture_distance) const {
    const T open = max(gap, T(0));
    const T overlap = max(T(-gap), T(0));
    const T lost = exp(T(-open * decay_rate)) - exp(T(-rupture_distance * decay_rate));
    return amplitude * (max(lost, T(0)) / decay_rate + overlap);
  }
};

/// 1/lambda of Eq. 11; a vanishing volume gives a force that acts in contact only.
template <Scalar T>
T decay_rate(const bridge<T>& b, double decay_constant) {
  const T size_ratio = min(b.radius_i, b.radius_j) / max(b.radius_i, b.radius_j);
  const T curvature = T(1) / b.radius_i + T(1) / b.radius_j;
  const T length = T(decay_constant) * sqrt(T(T(0.5) * b.volume * size_ratio * curvature));
  return T(1) / max(length, T(tiny));
}

}  // namespace pendular::capillary
