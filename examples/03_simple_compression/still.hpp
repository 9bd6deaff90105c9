// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../common/snapshot.hpp"

#include <array>

/// Grains that the test has hardly moved: by less than a tenth of the shortening.
struct still_grains {
  static constexpr int slices = 5;
  double share = 0;                       // of all grains
  std::array<double, slices> by_slice{};  // the same of each fifth of the height, from the floor up
  /// Radius about the axis within which nine tenths of a slice's still grains lie, m; not a number without any.
  std::array<double, slices> radius{};
};

still_grains still_grains_of(const examples::snapshot& s, double shortening);
