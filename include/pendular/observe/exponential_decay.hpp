// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace pendular::observe {

/// p(x) proportional to exp(-rate x) on a window.
struct exponential_decay {
  double rate = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  // standard error, from the curvature of the likelihood
  std::size_t count = 0;                                    // values in the window
};

/// Where a decay is looked for, in units of the values.
struct decay_window {
  double low, high;
};

namespace detail {
/// Mean of x on [0, 1] with the density exp(-r x), and its variance.
struct truncated_exponential {
  double mean, variance;

  explicit truncated_exponential(double r) {
    if (std::abs(r) < 1e-2) {  // where the closed forms lose all digits; the next terms are r^3/720 and r^2/240
      mean = 0.5 - r / 12, variance = 1.0 / 12 - r * r / 240;
      return;
    }
    const double beyond = std::expm1(r);
    mean = 1 / r - 1 / beyond;
    variance = 1 / (r * r) - (1 + 1 / beyond) / beyond;
  }
};
}  // namespace detail

/// The decay of the values / unit that lie in the window, by maximum likelihood of an exponential cut off at both ends
/// of it: no bins, and nothing outside of the window counts. Not a number for fewer than two values; infinite, with an
/// error that is no number, where values so close to one end say no more than that it is steep.
/// Source: F. Deemer and D. Votaw 1955, Annals of Mathematical Statistics 26, 498, with both signs of the rate.
/// Errors: a window that is not finite and increasing, a unit not positive and finite.
inline exponential_decay exponential_decay_of(std::span<const double> values, double unit, decay_window window) {
  constexpr auto page = "docs/reference/observe.md";
  expects_positive("the unit of an exponential decay", unit, page);
  expects(std::isfinite(window.low), "the lower end of a window", window.low, "finite", page);
  expects(std::isfinite(window.high) && window.high > window.low, "the upper end of a window", window.high,
          "finite and above the lower one", page);
  const double width = window.high - window.low;
  expects(std::isfinite(width), "the width of a window", width, "finite", page);
  exponential_decay found;
  double sum = 0;
  for (const double value : values) {
    const double x = value / unit;
    if (!(x >= window.low && x <= window.high)) continue;
    sum += (x - window.low) / width;
    ++found.count;
  }
  if (found.count < 2) return found;
  const auto n = static_cast<double>(found.count);
  constexpr double steepest = 700;  // over the width, that exp can bear
  double low = -steepest, high = steepest;
  for (int k = 0; k < 100; ++k) {  // the mean falls with the rate
    const double middle = 0.5 * (low + high);
    (detail::truncated_exponential(middle).mean > sum / n ? low : high) = middle;
  }
  if (std::abs(low) > 0.99 * steepest) {
    found.rate = std::copysign(std::numeric_limits<double>::infinity(), low);
    return found;
  }
  found.rate = low / width;
  found.error = 1 / (width * std::sqrt(n * detail::truncated_exponential(low).variance));
  return found;
}

}  // namespace pendular::observe
