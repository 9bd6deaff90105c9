// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>

namespace pendular {

/// What an evaluation of contacts found besides forces.
struct contact_findings {
  bool liquid_event = false;  // a bridge breaks or may form
  bool trouble = false;       // an overlap beyond the limit or a value that is not finite

  contact_findings& operator|=(const contact_findings& other) {
    liquid_event |= other.liquid_event;
    trouble |= other.trouble;
    return *this;
  }
};

namespace simd {
inline namespace PENDULAR_REGISTERS {
/// The same lane by lane, so that blocks do not reduce what a whole chunk can reduce at once.
struct lane_findings {
  block event{-1.0};  // positive where a bridge breaks or may form
  block room{1.0};    // below 0 where an overlap is beyond the limit
  block zero{0.0};    // no number where a value is not finite

  void demand_finite(const block& values) { zero += 0.0 * values; }
  contact_findings folded() const { return {any(event > 0), !all(room > 0 && zero == 0)}; }
};
}  // namespace PENDULAR_REGISTERS
}  // namespace simd
using simd::lane_findings;

}  // namespace pendular
