// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/liquid/pair_view.hpp>

#include <cstddef>

namespace pendular::observe {

/// Unit vector from the first grain of a pair to the second.
inline vector pair_normal(const pair_view& view, std::size_t p) {
  const vector branch = view.position[view.grain_j(p)] - view.position[view.grain_i(p)];
  return (1 / norm(branch)) * branch;
}

/// Of a pair, N, repulsion positive: contact, damping and bridge together. `view` is that of the system.
template <class System>
double normal_force(const System& s, const pair_view& view, std::size_t p) {
  return -dot(s.contacts().force(p), pair_normal(view, p));
}

}  // namespace pendular::observe
