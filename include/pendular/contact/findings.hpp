// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace pendular
