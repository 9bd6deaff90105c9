// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/inputs.hpp>

namespace pendular::capillary {

/// What the regressions of Mikami et al. and Soulie et al. prepare per bond: amplitude (offset + exp(exponent - rate D)).
template <class T>
struct exponential_with_offset {
  T amplitude;  // N
  T rate;       // 1/m
  T exponent;
  T offset;

  /// Pull, N; never less than nothing.
  T attraction(const T& gap) const {
    return amplitude * max(T(offset + exp(T(exponent - max(gap, T(0)) * rate))), T(0));
  }

  /// Work from the gap to the rupture distance, J.
  T work(const T& gap, const T& rupture_distance) const {
    const T from = min(T(max(gap, T(0))), rupture_distance), overlap = max(T(-gap), T(0));
    const T decayed = exp(T(exponent - from * rate)) - exp(T(exponent - rupture_distance * rate));
    return amplitude * (offset * (rupture_distance - from) + decayed / rate) + overlap * attraction(T(0));
  }
};

}  // namespace pendular::capillary
