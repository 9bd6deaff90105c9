// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pendular::io {

using colour = std::array<double, 3>;  // sRGB, each in [0, 1]

/// Viridis of matplotlib (S. van der Walt and N. Smith, 2015; CC0), eleven of its 256 entries, straight in between:
/// equal steps of the argument look equal, also in grey and to the colour-blind. `fraction` is clamped to [0, 1];
/// grey for one that is not a number.
inline colour viridis(double fraction) {
  static constexpr std::array<colour, 11> entries{{{0.267004, 0.004874, 0.329415},
                                                   {0.282623, 0.140926, 0.457517},
                                                   {0.253935, 0.265254, 0.529983},
                                                   {0.206756, 0.371758, 0.553117},
                                                   {0.163625, 0.471133, 0.558148},
                                                   {0.127568, 0.566949, 0.550556},
                                                   {0.134692, 0.658636, 0.517649},
                                                   {0.266941, 0.748751, 0.440573},
                                                   {0.477504, 0.821444, 0.318195},
                                                   {0.741388, 0.873449, 0.149561},
                                                   {0.993248, 0.906157, 0.143936}}};
  if (std::isnan(fraction)) return {0.6, 0.6, 0.6};
  const double place = std::clamp(fraction, 0.0, 1.0) * (entries.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), entries.size() - 2);
  colour mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = std::lerp(entries[below][i], entries[below + 1][i], place - static_cast<double>(below));
  return mixed;
}

}  // namespace pendular::io
