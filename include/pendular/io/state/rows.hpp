// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>
#include <pendular/io/state/grains.hpp>
#include <pendular/io/state/records.hpp>
#include <pendular/liquid/pair_view.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pendular::io::detail {

/// Contact memories that are not all zero: key (one id, or two), then the numbers.
template <class Table, class KeyOf>
void put_memories(checkpoint_writer& out, const std::string& name, const Table& table, std::size_t rows,
                  const KeyOf& key_of) {
  std::vector<std::int64_t> keys;
  std::vector<double> values;
  for (std::size_t p = 0; p < rows; ++p) {
    bool any = false;
    for (std::size_t k = 0; k < Table::width; ++k) any |= table.column(k)[p] != 0;
    if (!any) continue;
    key_of(p, keys);
    for (std::size_t k = 0; k < Table::width; ++k) values.push_back(table.column(k)[p]);
  }
  out.put(name + ".keys", keys);
  out.put(name + ".values", values);
}

/// What acts on every row that does, as numbers: key, then the row.
template <class Contacts, class KeyOf>
void put_actions(checkpoint_writer& out, const std::string& name, const Contacts& contacts, std::size_t rows,
                 const KeyOf& key_of) {
  using action = action_row<Contacts::rotates>;
  std::vector<std::int64_t> keys;
  std::vector<double> values;
  for (std::size_t p = 0; p < rows; ++p) {
    const auto numbers = std::bit_cast<std::array<double, sizeof(action) / sizeof(double)>>(contacts.actions()[p]);
    if (std::all_of(numbers.begin(), numbers.begin() + 4, [](double v) { return v == 0; })) continue;
    key_of(p, keys);
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  out.put(name + ".keys", keys);
  out.put(name + ".values", values);
}
template <class Contacts, class RowOf>
void get_actions(const checkpoint_reader& in, const std::string& name, Contacts& contacts, std::size_t ids_per_key,
                 const RowOf& row_of) {
  using action = action_row<Contacts::rotates>;
  constexpr std::size_t width = sizeof(action) / sizeof(double);
  const auto keys = get_keys<std::int64_t>(in, name + ".keys", ids_per_key);
  const auto values = in.get<std::vector<double>>(name + ".values", keys.size() / ids_per_key * width);
  for (std::size_t n = 0; n * ids_per_key < keys.size(); ++n) {
    std::array<double, width> numbers;
    for (std::size_t k = 0; k < width; ++k) numbers[k] = values[n * width + k];
    contacts.restore_action(row_of(keys.data() + n * ids_per_key), std::bit_cast<action>(numbers));
  }
  contacts.know_actions();
}

template <class Table, class RowOf>
void get_memories(const checkpoint_reader& in, const std::string& name, Table& table, std::size_t ids_per_key,
                  const RowOf& row_of) {
  const auto keys = get_keys<std::int64_t>(in, name + ".keys", ids_per_key);
  const auto values = in.get<std::vector<double>>(name + ".values", keys.size() / ids_per_key * Table::width);
  for (std::size_t n = 0; n * ids_per_key < keys.size(); ++n) {
    const std::size_t row = row_of(keys.data() + n * ids_per_key);
    for (std::size_t k = 0; k < Table::width; ++k) table.column(k)[row] = values[n * Table::width + k];
  }
}

/// Row of the pair of two grains, by their ids. Errors: std::runtime_error.
template <class System>
std::size_t pair_of(const System& s, const pair_view& view, const row_index& rows, const std::int64_t* key) {
  const auto pairs = s.pairs().pairs_of(rows.at(key[0]));
  const auto partner = [&](const auto& incidence) {
    const auto p = static_cast<std::size_t>(incidence.pair);
    return view.id[incidence.is_second ? view.grain_i(p) : view.grain_j(p)];
  };
  const auto found = std::lower_bound(pairs.begin(), pairs.end(), key[1],
                                      [&](const auto& n, std::int64_t wanted) { return partner(n) < wanted; });
  if (found == pairs.end() || partner(*found) != key[1] || found->is_second) {
    refuse_content("it has a contact of grains " + std::to_string(key[0]) + " and " + std::to_string(key[1]) +
                   ", which are not neighbours");
  }
  return static_cast<std::size_t>(found->pair);
}

}  // namespace pendular::io::detail
