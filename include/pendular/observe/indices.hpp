// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <range/v3/view/iota.hpp>
#include <range/v3/view/transform.hpp>

#include <cstddef>
#include <cstdint>

namespace pendular::observe {

/// 0, 1, ... count - 1 as a range. Counted in 32 bits, like the pairs themselves: range-v3 gives wider integers a
/// difference type that no compiler knows how to optimise.
inline auto indices(std::size_t count) {
  return ::ranges::views::iota(std::int32_t{0}, static_cast<std::int32_t>(count)) |
         ::ranges::views::transform([](std::int32_t k) { return static_cast<std::size_t>(k); });
}

}  // namespace pendular::observe
