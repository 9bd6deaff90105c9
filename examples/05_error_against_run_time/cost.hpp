// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

// What every law costs on this machine.
namespace cost {

/// Nanoseconds for one bridge; `lanes` are eight doubles, `float_lanes` sixteen floats at a time.
struct of_law {
  std::string law;
  double in_double, in_float, in_lanes, in_float_lanes, preparation;
};

/// Medians of interleaved rounds, so that a busy machine slows all laws alike.
std::vector<of_law> measure();

}  // namespace cost
