// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/concepts.hpp>

namespace pendular::protocol {

/// Protocol 0: the film of a grain goes to its bonds in proportion to the partners' diameters.
/// Source: Richefeu et al. 2007, section 2.2.
struct neighbours {
  double offer(const bond_side& b) const { return 2.0 * b.partner_radius; }
  double merge(double a, double b) const { return a + b; }
  /// Volume per diameter, m2.
  double settle(double diameters, double film) const { return diameters > 0 ? film / diameters : 0.0; }
  double pull(const bond_side& b, double grant) const { return grant * offer(b); }
};

}  // namespace pendular::protocol
