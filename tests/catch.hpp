// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Catch2, version 3 or 2, in the vocabulary of both: version 2 puts Approx into the global namespace itself.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

/// Equal within a relative error; Approx on its own grants a hundred float epsilons.
inline Approx within(double relative_error, double expected) {
  return Approx(expected).epsilon(relative_error).margin(0).scale(0);
}

/// Equal within an absolute error.
inline Approx near(double absolute_error, double expected) {
  return Approx(expected).epsilon(0).margin(absolute_error).scale(0);
}
