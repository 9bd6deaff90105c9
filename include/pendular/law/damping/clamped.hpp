// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/resistance.hpp>

namespace pendular::damping {

/// Any damping law that never makes a dry contact attractive: what it answers, but not less than -push, so that the
/// contact ends where elastic and damping force cancel and not where the overlap is 0.
/// Units: N. Valid where its law is. Beside a linear spring `clamped{viscous{alpha}}` has the restitution
/// exp(-2 alpha arccos(alpha) / sqrt(1 - alpha^2)), e^-2 at 1; beside a Hertz contact that of alpha sqrt(6/5).
/// Source: T. Schwager, T. Poeschel 2007, Granular Matter 9, 465; for Hertz by the substitution of F. Antypov, J. A. Elliott
/// 2011, EPL 94, 50004.
template <class Dashpot>
struct clamped {
  static_assert(DampingLaw<Dashpot>, "damping::clamped takes a damping law, such as clamped{viscous{0.8}} "
                                     "(docs/reference/laws.md)");

  Dashpot dashpot;

  template <class T>
  using contact_memory = contact_memory_t<Dashpot, T>;

  template <Scalar T, class... Memory>
  T resistance(const approach<T>& a, const elastic<T>& spring, Memory&... memory) const {
    const T force = pendular::resistance(dashpot, a, spring, memory...);
    return max(force, T(-spring.push));
  }
};

template <class Dashpot>
clamped(Dashpot) -> clamped<Dashpot>;

template <class Dashpot>
void validate(const clamped<Dashpot>& law) {
  if constexpr (requires { validate(law.dashpot); }) validate(law.dashpot);
}

}  // namespace pendular::damping
