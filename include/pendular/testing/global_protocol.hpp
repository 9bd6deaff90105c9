// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/concepts.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/small_door.hpp>

#include <cmath>

namespace pendular::testing {

/// What a global protocol promises beyond its signature, tried on a few grains.
template <GlobalProtocol P>
report global_protocol_report(const P& protocol) {
  report broken;
  demand(broken, protocol.period > 0, "the period must be at least 1", {{"period", double(protocol.period)}});
  detail::demand_sound_acts(broken, [&](small_door& door) {
    if constexpr (requires { protocol.reach(door); }) {
      const double reach = protocol.reach(door);
      demand(broken, reach >= 0 && std::isfinite(reach), "the reach must be at least 0 and finite", {{"reach", reach}});
    }
    protocol.redistribute(door);
    demand(broken, door.outside() == 0, "a protocol must not bring liquid in or take it out",
           {{"outside", door.outside()}});
  });
  return broken;
}

}  // namespace pendular::testing
