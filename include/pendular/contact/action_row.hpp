// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/core/vec.hpp>

#include <type_traits>

namespace pendular {

/// What acts, read and written as one row. Of a pair: the force on its first grain, N, and 1 if it touches, else 0; where
/// grains rotate also the torque per lever arm, N, the same for both grains, and the gap, m. Of a grain: the sum of the
/// forces, N, and the number of contacts; where grains rotate also the torque, N m.
template <bool Rotates>
using action_row = std::conditional_t<Rotates, octet, quad>;

inline const quad& push_of(const quad& a) { return a; }
inline const quad& push_of(const octet& a) { return a.low; }
inline quad& push_of(quad& a) { return a; }
inline quad& push_of(octet& a) { return a.low; }

inline vector vector_of(const quad& a) { return {a.a, a.b, a.c}; }

inline void add(quad& to, const vector& v, double d) { to = {to.a + v.x, to.b + v.y, to.c + v.z, to.d + d}; }

}  // namespace pendular
