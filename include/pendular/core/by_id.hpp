// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular {

/// Puts rows of grains into the order of their ids, which no list of neighbours and no number of parts changes.
template <class Row>
void sort_by_id(std::vector<Row>& rows, std::span<const std::int64_t> id) {
  std::sort(rows.begin(), rows.end(),
            [&](Row a, Row b) { return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)]; });
}

}  // namespace pendular
