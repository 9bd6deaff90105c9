// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pendular {

/// Policy of a material: add up the work done by dashpots and friction.
struct energy_book {};

/// Work taken out of the motion since the start, J.
struct contact_work {
  double damping = 0;
  double friction = 0;  // includes what friction springs store
};

}  // namespace pendular
