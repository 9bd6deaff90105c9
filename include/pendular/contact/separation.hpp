// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/core/vec.hpp>

namespace pendular {

/// How two bodies are apart.
template <class T>
struct separation {
  Vec3<T> normal;  // from the grain to its partner
  T gap;           // m
  T radius_i;      // m
  T radius_j;      // m; infinite for a wall
};

/// Of two spheres: position and radius of each.
template <class Row>
separation<decltype(Row::d)> between_spheres(const Row& i, const Row& j) {
  using T = decltype(Row::d);
  const Vec3<T> branch{j.a - i.a, j.b - i.b, j.c - i.c};
  const T distance = norm(branch);
  return {T(1.0 / distance) * branch, distance - i.d - j.d, i.d, j.d};
}

}  // namespace pendular
