// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

/// Seconds that some work takes.
template <class Work>
double timed(const Work& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}
