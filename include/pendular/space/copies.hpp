// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/host.hpp>
#include <pendular/space/grains.hpp>

#include <cstddef>
#include <span>

namespace pendular {

namespace detail {
template <class Row, class Grains, Host H>
void update_rows(Grains& g, const H& host) {
  constexpr std::size_t width = sizeof(Row) / sizeof(double);
  const std::span<Row> rows = g.template rows<Row>();
  host.update_copies({reinterpret_cast<double*>(rows.data()), width * rows.size()}, width);
}
}  // namespace detail

/// What moves of the copies of grains that other parts of a scene keep, from their keepers: places, velocities, contacts.
template <class Grains, Host H>
void update_copies(Grains& g, const H& host) {
  detail::update_rows<grain_row::place>(g, host);
  detail::update_rows<grain_row::motion>(g, host);
  if constexpr (Grains::rotate) detail::update_rows<grain_row::spin>(g, host);
}

}  // namespace pendular
