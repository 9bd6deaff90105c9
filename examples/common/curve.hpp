// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace examples {

/// Mean of y over the window of x around every point, which is narrower near the ends: as far to one side as to the other,
/// so that a curve that rises from zero starts there. x does not decrease.
std::vector<double> smoothed(const std::vector<double>& x, const std::vector<double>& y, double window);

struct estimate {
  double mean = 0;
  double error = 0;
};

/// Mean of y where x is at least `from`, and the standard error that it would have if the means of ten stretches were
/// independent: a lower bound where the curve has a trend or a long memory. Not a number if nothing is there.
estimate mean_beyond(const std::vector<double>& x, const std::vector<double>& y, double from);

}  // namespace examples
