// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

// Inlines all that a function calls, where that is what its speed stands on. Not under sanitizers, whose checks make
// such a function too long to compile.
#if defined(__SANITIZE_ADDRESS__)
#define PENDULAR_FLATTEN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PENDULAR_FLATTEN
#endif
#endif
#ifndef PENDULAR_FLATTEN
#define PENDULAR_FLATTEN [[gnu::flatten]]
#endif

namespace pendular {

/// W scalars at a time: one SIMD register or a few, whatever the machine has.
template <int W>
using lanes = Eigen::Array<double, W, 1>;

/// Pairs are evaluated this many at a time. Fixed, so that results do not depend on the machine's register width.
inline constexpr int lane_count = 8;
using block = lanes<lane_count>;

/// A number of rows rounded up to whole blocks.
constexpr std::size_t padded(std::size_t rows) {
  constexpr auto width = static_cast<std::size_t>(lane_count);
  return (rows + width - 1) / width * width;
}

inline block load(const double* from) { return Eigen::Map<const block>(from); }
inline void store(double* to, const block& values) { Eigen::Map<block>{to} = values; }

}  // namespace pendular
