// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::capillary {

/// What several fits to Laplace-Young prepare per bond: the pull amplitude (1 + a D) / (1 + b D + c D^2).
template <class T>
struct rational_bridge {
  T amplitude;      // N
  T above;          // a, 1/m
  T below, square;  // b, 1/m, and c, 1/m2

  /// Pull, N.
  T attraction(const T& gap) const {
    const T d = max(gap, T(0));
    return amplitude * (T(1) + above * d) / (T(1) + d * (below + square * d));
  }
};

}  // namespace pendular::capillary
