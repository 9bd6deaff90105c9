// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/concepts.hpp>

#include <cstdint>
#include <limits>
#include <tuple>

namespace pendular::protocol {

/// Protocol 3: the film of a grain goes to its lowest bond on its lower hemisphere. Needs a gravity in the integrator.
/// Source: Richefeu et al. 2007, section 4.2.2.
struct gravity {
  static constexpr bool needs_gravity = true;

  /// The partner's id decides between bonds of equal height.
  struct lowest {
    double height;  // m, below the centre
    std::int64_t partner;
  };
  struct grant {
    lowest receiver;
    double film;  // m3
  };

  lowest offer(const bond_side& b) const {
    return {b.contact_height < 0 ? b.contact_height : std::numeric_limits<double>::infinity(), b.partner};
  }
  lowest merge(const lowest& a, const lowest& b) const {
    return std::tie(a.height, a.partner) < std::tie(b.height, b.partner) ? a : b;
  }
  grant settle(const lowest& receiver, double film) const { return {receiver, film}; }
  double pull(const bond_side& b, const grant& g) const {
    return b.contact_height < 0 && b.partner == g.receiver.partner ? g.film : 0.0;
  }
};

}  // namespace pendular::protocol
