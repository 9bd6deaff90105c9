// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/liquid/door_archetype.hpp>

#include <concepts>
#include <cstdint>
#include <string_view>

namespace pendular {

/// Brings liquid into a scene or takes it out, once per period (steps), under the name of an account of the ledger.
template <class S>
concept Source = Copyable<S> && requires(const S source, outside_door_archetype& door) {
  { source.period } -> std::convertible_to<std::int64_t>;
  { source.account } -> std::convertible_to<std::string_view>;
  source.act(door);
};

}  // namespace pendular
