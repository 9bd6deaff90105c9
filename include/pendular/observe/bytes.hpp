// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>
#include <pendular/contact/work_sums.hpp>
#include <pendular/core/lanes.hpp>
#include <pendular/core/scalar_table.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <cstddef>
#include <cstdint>
#include <tuple>

namespace pendular::observe {

namespace detail {
template <template <class> class Record>
inline constexpr std::size_t bytes_of = scalar_table<Record>::width * sizeof(double);

/// Of a row of contacts, but for the byte that each block of them has.
template <class Contacts, class System>
consteval std::size_t bytes_of_contact() {
  using bonds = typename System::bonds_type;
  constexpr std::size_t gaps = Contacts::carries_bridges && bonds::forms_on_closing ? 2 : 1;
  std::size_t bytes = sizeof(action_row<Contacts::rotates>) + gaps * sizeof(double) +
                      bytes_of<Contacts::template memory> + bytes_of<Contacts::template constants>;
  if constexpr (System::material_type::keeps_energy_book) bytes += bytes_of<work_sums::account>;
  return bytes;
}

/// Of a row of the bonds: volume, two thresholds, coefficients.
template <class Contacts, class System>
consteval std::size_t bytes_of_bond() {
  if constexpr (Contacts::carries_bridges) {
    return 3 * sizeof(double) + bytes_of<System::bonds_type::template coefficients>;
  } else {
    return 0;
  }
}

/// As its list and the neighbours of its grains have it: two rows, and the pair as each of both sees it.
inline constexpr std::size_t bytes_of_listing = 2 * (sizeof(std::int32_t) + sizeof(pair_list::incidence));
}  // namespace detail

/// Bytes that a scene holds per listed pair, as follows from its composition: what nobody chose is not there. Lists are
/// padded to blocks of lane_count, and each block has one byte besides.
template <class System>
inline constexpr std::size_t bytes_per_pair = detail::bytes_of_listing +
                                              detail::bytes_of_contact<typename System::contacts_type, System>() +
                                              detail::bytes_of_bond<typename System::contacts_type, System>();

/// The same per grain, wherever it is: its columns and tags, where it was listed, its place in the lists of pairs and
/// walls, and its film.
template <class System>
inline constexpr std::size_t bytes_per_grain = System::grains_type::bytes_per_grain + sizeof(grain_row::place) +
                                               sizeof(std::int64_t) + sizeof(std::size_t) + sizeof(std::int32_t) +
                                               (System::wet ? sizeof(double) : 0);

/// What a grain near wall number `Wall` has besides, padded as pairs are. A grain near several walls has the load once.
template <class System, std::size_t Wall = 0>
inline constexpr std::size_t bytes_per_grain_at_wall = [] {
  using contacts = std::tuple_element_t<Wall, typename System::rows_type::wall_contacts_type>;
  constexpr std::size_t row = sizeof(std::int32_t), load = sizeof(action_row<contacts::rotates>);
  return row + load + detail::bytes_of_contact<contacts, System>() + detail::bytes_of_bond<contacts, System>();
}();

}  // namespace pendular::observe
