// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>

#include <cstdint>

/// What eight numbers add up to that are read as lanes, and as the rows of two quads. Not optimised, so that nothing is
/// inlined and the linker chooses among functions of one name.
static double sum_of(const double* numbers) {
  pendular::quad rows[2];
  for (int k = 0; k < 2; ++k) rows[k] = {numbers[4 * k], numbers[4 * k + 1], numbers[4 * k + 2], numbers[4 * k + 3]};
  const std::int32_t all[8] = {0, 1, 0, 1, 0, 1, 0, 1};
  const pendular::quad_block q = pendular::gather(rows, all);
  pendular::quad stored[8];
  pendular::store(stored, q);
  return sum(pendular::load(numbers)) + sum(q.a + q.b + q.c + q.d) / 4 + stored[1].d - rows[1].d;
}
