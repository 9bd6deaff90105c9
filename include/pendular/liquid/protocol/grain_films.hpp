// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/concepts.hpp>

namespace pendular::protocol {

/// Protocol 2: the liquid of a broken bond stays on its two grains, and the whole film of a grain is shared equally
/// among its new contacts of a step.
/// Source: Richefeu et al. 2007, section 3.2.
struct grain_films {
  double offer(const bond_side& b) const { return b.forming ? 1.0 : 0.0; }
  double merge(double a, double b) const { return a + b; }
  /// Volume per new contact, m3.
  double settle(double new_contacts, double film) const { return new_contacts > 0 ? film / new_contacts : 0.0; }
  double pull(const bond_side& b, double grant) const { return grant * offer(b); }
};

}  // namespace pendular::protocol
