// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/row_state.hpp>
#include <pendular/io/state/grains.hpp>
#include <pendular/io/state/records.hpp>
#include <pendular/liquid/pair_view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pendular::io::detail {

/// Every row that acts, remembers or has done something: key (one id, or two), then its numbers.
class row_record {
 public:
  /// The numbers of the next row go here; a row of nothing but 0 is not kept.
  std::vector<double>& numbers() {
    numbers_.clear();
    return numbers_;
  }
  bool is_idle() const {
    return std::all_of(numbers_.begin(), numbers_.end(), [](double v) { return v == 0; });
  }
  std::vector<std::int64_t>& keys() { return keys_; }
  /// Keeps the numbers, under the key that was added last.
  void keep() { values_.insert(values_.end(), numbers_.begin(), numbers_.end()); }
  void put(checkpoint_writer& out, const std::string& name) const {
    out.put(name + ".keys", keys_);
    out.put(name + ".values", values_);
  }

 private:
  std::vector<std::int64_t> keys_;
  std::vector<double> values_, numbers_;
};

template <class Contacts, class KeyOf>
void put_rows(checkpoint_writer& out, const std::string& name, const Contacts& contacts, std::size_t rows,
              const KeyOf& key_of) {
  row_record record;
  for (std::size_t p = 0; p < rows; ++p) {
    auto state = contacts.take(p);
    state.gap = 0;  // is that of the positions
    for_each_number(state, [&numbers = record.numbers()](double& v) { numbers.push_back(v); });
    if (record.is_idle()) continue;
    key_of(p, record.keys());
    record.keep();
  }
  record.put(out, name);
}
template <class Contacts, class RowOf>
void get_rows(const checkpoint_reader& in, const std::string& name, Contacts& contacts, std::size_t ids_per_key,
              const RowOf& row_of) {
  using state_type = typename Contacts::state_type;
  const auto keys = get_keys<std::int64_t>(in, name + ".keys", ids_per_key);
  const auto values =
      in.get<std::vector<double>>(name + ".values", keys.size() / ids_per_key * number_count<state_type>());
  auto next = values.begin();
  for (std::size_t n = 0; n < keys.size(); n += ids_per_key) {
    const std::size_t row = row_of(keys.data() + n);
    state_type state{};
    for_each_number(state, [&](double& v) { v = *next++; });
    state.gap = contacts.take(row).gap;
    contacts.put(row, state);
  }
  contacts.renew_only();
}

/// What contacts have done that are listed no more, J.
template <class Contacts>
void put_work(checkpoint_writer& out, const std::string& name, const Contacts& contacts) {
  if constexpr (requires { contacts.work().keep(); }) {
    const auto settled = contacts.work().keep();
    put_sum(out, name + ".damping_work", settled.damping);
    put_sum(out, name + ".friction_work", settled.friction);
  }
}
template <class Contacts>
void get_work(const checkpoint_reader& in, const std::string& name, Contacts& contacts) {
  if constexpr (requires { contacts.work().keep(); }) {
    contacts.work().restore({get_sum(in, name + ".damping_work"), get_sum(in, name + ".friction_work")});
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
