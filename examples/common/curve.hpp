// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace examples {

/// Mean of y over the window of x around every point; x does not decrease.
std::vector<double> smoothed(const std::vector<double>& x, const std::vector<double>& y, double window);

struct estimate {
  double mean = 0;
  double error = 0;  // standard error
};

/// Mean of y where x is at least `from`. The error is that of the means of ten stretches: neighbouring values are not
/// independent, stretches nearly so. Not a number if nothing is there.
estimate mean_beyond(const std::vector<double>& x, const std::vector<double>& y, double from);

}  // namespace examples
