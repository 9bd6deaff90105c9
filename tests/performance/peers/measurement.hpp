// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace peers {

/// What a code did in the measured steps; per grain, and the state that of the last step.
struct measurement {
  double time;      // of the processor, ns per step
  double contacts;  // between grains
  double bridges;
  double kinetic_energy;  // of translation, J
};

}  // namespace peers
