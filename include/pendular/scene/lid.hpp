// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/servo_stress.hpp>

namespace pendular::scene {

/// Loads a sample by a stress, Pa, on an area, m2. Light, and with a dashpot near critical for a layer of grains of
/// 1000 N/m and of their own mass; `mass_scaling` is that of the grains, and the dashpot does not follow it.
inline boundary::servo_stress loading_lid(double stress, double area, double mass_scaling = 1) {
  return {stress, area, 2 * area * mass_scaling, 2000 * area};
}

}  // namespace pendular::scene
