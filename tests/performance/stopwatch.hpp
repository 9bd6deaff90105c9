// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <ctime>

/// Seconds that some work takes.
template <class Work>
double timed(const Work& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Seconds of the processor that some work takes: those in which another program had the core do not count.
template <class Work>
double processor_time(const Work& work) {
  const std::clock_t began = std::clock();
  work();
  return static_cast<double>(std::clock() - began) / static_cast<double>(CLOCKS_PER_SEC);
}
