// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/liquid/protocol/concepts.hpp>

#include <cstdint>

namespace pendular::protocol {

/// Protocol 1: all liquid is distributed anew over all eligible pairs, V_b = alpha R^3, once per period.
/// Source: Richefeu et al. 2007, section 2.4, Eqs. 13-14. The paper ties the update to its contact list; here it has a
/// period of its own, so that neither skin nor threads change the physics.
struct homogeneous {
  std::int64_t period = 1000;  // steps

  template <class Door>
  double reach(const Door& door) const {
    return door.homogeneous_reach();
  }
  template <class Door>
  void redistribute(Door& door) const {
    door.share_homogeneously();
  }
};

inline void validate(const homogeneous& p) {
  expects(p.period > 0, "the period of the homogeneous protocol (steps)", static_cast<double>(p.period), "at least 1",
          "docs/reference/liquid.md");
}

}  // namespace pendular::protocol
