// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/source/concepts.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/small_door.hpp>

#include <string_view>

namespace pendular::testing {

/// What a source or sink promises beyond its signature, tried on a few grains.
template <Source S>
report source_report(const S& source) {
  report broken;
  demand(broken, source.period > 0, "the period must be at least 1", {{"period", double(source.period)}});
  const std::string_view account = source.account;
  demand(broken, !account.empty(), "the account must have a name", {});
  detail::demand_sound_acts(broken, [&](small_door& door) { source.act(door); });
  return broken;
}

}  // namespace pendular::testing
