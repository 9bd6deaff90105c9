// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pendular {

/// What the evaluation of contacts needs to know of the integrator and of its limits.
struct contact_clock {
  double time_step;       // s
  double velocity_lag;    // steps by which the velocities are older than the positions
  double overlap_limit;   // fraction of the smaller radius
  bool moving = true;     // false where forces are only looked at: nothing is remembered and no work is done
  std::int64_t step = 0;  // for whoever reports trouble
};

}  // namespace pendular
