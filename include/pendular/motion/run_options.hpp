// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <cmath>
#include <optional>

namespace pendular {

/// Numbers that are not physics.
struct run_options {
  std::optional<double> skin = {};  // of the Verlet list, in units of the smallest radius; empty: the cheapest
  double overlap_limit = 0.1;       // a larger overlap, in units of the smaller radius, stops the run
  double domain_margin = 10;        // a grain this many sizes of the packing away from it is lost
  bool force = false;               // run even if the scene breaks a limit
};

inline void validate(const run_options& o) {
  constexpr auto page = "docs/reference/system.md";
  const double skin = o.skin.value_or(1);
  expects(skin > 0 && skin < 10, "the skin in units of the smallest radius", skin, "in (0, 10)", page);
  expects(o.overlap_limit > 0 && o.overlap_limit < 1, "the overlap limit in units of the radius", o.overlap_limit,
          "in (0, 1)", page);
  expects(o.domain_margin >= 0 && std::isfinite(o.domain_margin), "the margin of the domain in sizes of the packing",
          o.domain_margin, "at least 0 and finite", page);
}

}  // namespace pendular
