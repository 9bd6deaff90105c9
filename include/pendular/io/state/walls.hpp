// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/io/state/rows.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pendular::io::detail {

/// visit(number) for all that changes of a wall while it is used, but its work. A wall of one's own need not keep its load.
template <class Wall, class Visit>
void for_each_number_of_wall(Wall& wall, const Visit& visit) {
  for_each_scalar<double>(wall.shape, visit);
  for_each_scalar<double>(wall.drive, visit);
  for_each_scalar<double>(wall.force, visit);
  if constexpr (requires { wall.load; }) for_each_scalar<double>(wall.load, visit);
}

template <class System>
void put_walls(checkpoint_writer& out, const System& s) {
  const auto view = s.view();
  std::size_t index = 0;
  s.for_each_wall([&](const auto& wall, const auto& contacts) {
    const std::string name = "wall." + std::to_string(index++);
    std::vector<double> state;
    for_each_number_of_wall(wall, [&](const double& v) { state.push_back(v); });
    state.push_back(wall.work);
    out.put(name, state);
    put_work(out, name, contacts);
    const auto key = [&](std::size_t k, std::vector<std::int64_t>& keys) { keys.push_back(view.id[contacts.row(k)]); };
    put_rows(out, name + ".rows", contacts, contacts.size(), key);
  });
}

template <class System>
void get_walls(const checkpoint_reader& in, System& s) {
  std::size_t index = 0;
  s.for_each_wall([&](auto& wall, auto& contacts) {
    std::size_t count = 1;
    for_each_number_of_wall(wall, [&](const double&) { ++count; });
    const std::string name = "wall." + std::to_string(index++);
    const auto state = in.get<std::vector<double>>(name, count);
    std::size_t k = 0;
    for_each_number_of_wall(wall, [&](double& v) { v = state[k++]; });
    wall.work = state[k];
    get_work(in, name, contacts);
    if constexpr (requires { validate(wall.shape); }) validate(wall.shape);
    if constexpr (requires { validate(wall.drive); }) validate(wall.drive);
  });
}

template <class System>
void get_wall_rows(const checkpoint_reader& in, System& s, const row_index& rows) {
  std::size_t index = 0;
  s.for_each_wall([&](auto&, auto& contacts) {
    std::vector<std::size_t> place(s.particles().size(), contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) place[contacts.row(k)] = k;
    const std::string name = "wall." + std::to_string(index++);
    const auto row = [&](const std::int64_t* key) {
      const std::size_t k = place[rows.at(*key)];
      if (k == contacts.size()) refuse_content("grain " + std::to_string(*key) + " is not near " + name);
      return k;
    };
    get_rows(in, name + ".rows", contacts, 1, row);
  });
}

}  // namespace pendular::io::detail
