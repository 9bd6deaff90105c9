// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/liquid/ledger.hpp>
#include <pendular/liquid/pair_view.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular::io {

namespace detail {

template <class System>
std::string composition() {
  return __PRETTY_FUNCTION__;
}

/// Rows of a column in the order of the grains' ids, as plain numbers.
template <class Column, class Grains>
std::vector<double> by_id(const Grains& g) {
  std::vector<double> flat;
  for (const std::size_t row : g.rows_by_id()) {
    for_each_scalar<double>(g.template get<Column>()[row], [&](const double& v) { flat.push_back(v); });
  }
  return flat;
}

template <class Column, class Grains>
void fill(Grains& g, const std::vector<double>& flat) {
  std::size_t k = 0;
  for (auto& row : g.template get<Column>()) {
    for_each_scalar<double>(row, [&](double& v) { v = flat.at(k++); });
  }
}

/// visit("name", column tag) for every column that a checkpoint keeps as numbers.
template <class Grains, class Visit>
void for_each_column(const Visit& visit) {
  visit("grain.position", pendular::column::position{});
  visit("grain.velocity", pendular::column::velocity{});
  visit("grain.force", pendular::column::force{});
  visit("grain.radius", pendular::column::radius{});
  visit("grain.inverse_mass", pendular::column::inverse_mass{});
  if constexpr (Grains::rotate) {
    visit("grain.angular_velocity", pendular::column::angular_velocity{});
    visit("grain.torque", pendular::column::torque{});
    visit("grain.inverse_inertia", pendular::column::inverse_inertia{});
  }
  if constexpr (Grains::count_contacts) visit("grain.contacts", pendular::column::contacts{});
}

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

template <class Table, class RowOf>
void get_memories(const checkpoint_reader& in, const std::string& name, Table& table, std::size_t ids_per_key,
                  const RowOf& row_of) {
  const auto keys = in.get<std::vector<std::int64_t>>(name + ".keys");
  const auto values = in.get<std::vector<double>>(name + ".values");
  for (std::size_t n = 0; n * ids_per_key < keys.size(); ++n) {
    const std::size_t row = row_of(keys.data() + n * ids_per_key);
    for (std::size_t k = 0; k < Table::width; ++k) table.column(k)[row] = values.at(n * Table::width + k);
  }
}

template <class System>
void put_liquid(checkpoint_writer& out, const System& s) {
  const auto& book = s.bridges().book();
  const auto view = s.view();
  std::vector<std::int64_t> keys;
  std::vector<double> volumes, films;
  view.for_each_row([&](std::size_t p) {
    if (!s.bridges().is_bonded(p)) return;
    const auto [i, j] = view.ids(p);
    keys.insert(keys.end(), {i, j});
    volumes.push_back(book.bonds()[p]);
  });
  for (const std::size_t row : s.particles().rows_by_id()) films.push_back(book.films()[row]);
  const auto books = book.keep();
  out.put("liquid.keys", keys);
  out.put("liquid.volumes", volumes);
  out.put("liquid.films", films);
  out.put("liquid.books", std::vector<double>{books.reservoir, books.residue, books.introduced, s.bridges().work()});
  const auto& outside = s.bridges().outside();
  out.put("liquid.outside", std::vector<std::int64_t>{outside.capillary_law, outside.rupture_law});
  out.put("liquid.reach", s.bridges().reach(view));
  const auto& selection = s.selection();
  out.put("liquid.selection", std::vector<double>{selection.thinning, selection.widest_gap, selection.film_thickness});
  out.put("liquid.seed", selection.seed);
  out.put("liquid.torn", std::uint64_t{s.has_torn_bonds()});
  out.put("liquid.events", std::vector<std::int64_t>{s.events().ruptures, s.events().formations});
}

template <class System>
std::size_t pair_of(const System& s, const pair_view& view, const std::vector<std::size_t>& rows,
                    const std::int64_t* key) {
  for (const auto& incidence : s.pairs().pairs_of(rows.at(static_cast<std::size_t>(key[0])))) {
    const auto p = static_cast<std::size_t>(incidence.pair);
    if (!incidence.is_second && view.id[view.grain_j(p)] == key[1]) return p;
  }
  throw std::runtime_error("the checkpoint has a contact of grains " + std::to_string(key[0]) + " and " +
                           std::to_string(key[1]) + " that are not neighbours: it was written by another scene");
}

/// Row of the bonds with this key, whose second number is negative for a wall.
template <class System>
std::size_t bond_row_of(const System& s, const pair_view& view, const std::vector<std::size_t>& rows,
                        const std::int64_t* key) {
  if (key[1] >= 0) return pair_of(s, view, rows, key);
  std::size_t found = view.rows();
  view.for_each_wall_row_of(rows.at(static_cast<std::size_t>(key[0])), [&](std::size_t p) {
    if (view.ids(p).second == key[1]) found = p;
  });
  if (found < view.rows()) return found;
  throw std::runtime_error("the checkpoint has a bridge of grain " + std::to_string(key[0]) + " to wall " +
                           std::to_string(-1 - key[1]) + ", which it is not near: it was written by another scene");
}

template <class System>
void get_liquid(const checkpoint_reader& in, System& s, const std::vector<std::size_t>& rows) {
  const auto keys = in.get<std::vector<std::int64_t>>("liquid.keys");
  const auto volumes = in.get<std::vector<double>>("liquid.volumes");
  const auto view = s.view();
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    s.bridges().restore(bond_row_of(s, view, rows, keys.data() + 2 * n), volumes[n], view);
  }
  const auto books = in.get<std::vector<double>>("liquid.books");
  s.bridges().book().restore(ledger::books{books.at(0), books.at(1), books.at(2)});
  s.bridges().restore_work(books.at(3));
  const auto outside = in.get<std::vector<std::int64_t>>("liquid.outside");
  s.bridges().restore_outside({outside.at(0), outside.at(1)});
}

template <class System>
void put_walls(checkpoint_writer& out, const System& s) {
  const auto view = s.view();
  std::size_t index = 0;
  s.for_each_wall([&](const auto& wall, const auto& contacts) {
    const std::string name = "wall." + std::to_string(index++);
    std::vector<double> state;
    const auto keep = [&](const double& v) { state.push_back(v); };
    for_each_scalar<double>(wall.shape, keep);
    for_each_scalar<double>(wall.drive, keep);
    for_each_scalar<double>(wall.force, keep);
    const auto done = contacts.work().total();
    state.insert(state.end(), {wall.work, done.damping, done.friction});
    out.put(name, state);
    const auto key = [&](std::size_t k, std::vector<std::int64_t>& keys) { keys.push_back(view.id[contacts.row(k)]); };
    put_memories(out, name + ".memory", contacts.memories(), contacts.size(), key);
    if constexpr (requires { contacts.work().last_forces(); }) {
      put_memories(out, name + ".last_force", contacts.work().last_forces(), contacts.size(), key);
    }
  });
}

template <class Grains>
void get_grains(const checkpoint_reader& in, Grains& g) {
  const auto count = static_cast<std::size_t>(in.get<std::uint64_t>("system.grains"));
  g.resize(count);
  for_each_column<Grains>(
      [&](const std::string& name, auto column) { fill<decltype(column)>(g, in.get<std::vector<double>>(name)); });
  const auto ids = g.template get<pendular::column::id>();
  for (std::size_t k = 0; k < count; ++k) ids[k] = static_cast<std::int64_t>(k);
}

template <class System>
void get_walls(const checkpoint_reader& in, System& s) {
  std::size_t index = 0;
  s.for_each_wall([&](auto& wall, auto& contacts) {
    const auto state = in.get<std::vector<double>>("wall." + std::to_string(index++));
    std::size_t k = 0;
    const auto restore = [&](double& v) { v = state.at(k++); };
    for_each_scalar<double>(wall.shape, restore);
    for_each_scalar<double>(wall.drive, restore);
    for_each_scalar<double>(wall.force, restore);
    wall.work = state.at(k);
    contacts.work().restore({state.at(k + 1), state.at(k + 2)});
  });
}

/// Sets the clock and lists the neighbours, wide enough for the bridges that are still to be put back.
template <class System>
void list_again(const checkpoint_reader& in, System& s) {
  const auto steps = in.get<std::int64_t>("system.steps");
  if constexpr (System::wet) {
    auto& book = s.bridges().book();
    const auto films = in.get<std::vector<double>>("liquid.films");
    book.resize_films(films.size());
    for (std::size_t k = 0; k < films.size(); ++k) book.restore(ledger::film_of(k), films[k]);
    const auto events = in.get<std::vector<std::int64_t>>("liquid.events");
    const auto selection = in.get<std::vector<double>>("liquid.selection");
    s.resume_at(steps, {selection.at(0), in.get<std::uint64_t>("liquid.seed"), selection.at(1), selection.at(2)},
                {events.at(0), events.at(1)}, in.get<std::uint64_t>("liquid.torn") != 0);
    s.canonicalise(in.get<double>("liquid.reach"));
  } else {
    s.resume_at(steps, {}, {}, false);
    s.canonicalise();
  }
}

template <class System>
void get_wall_memories(const checkpoint_reader& in, System& s, const std::vector<std::size_t>& rows) {
  std::size_t index = 0;
  s.for_each_wall([&](auto&, auto& contacts) {
    std::vector<std::size_t> place(rows.size(), rows.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) place[contacts.row(k)] = k;
    const std::string name = "wall." + std::to_string(index++);
    const auto row = [&](const std::int64_t* key) { return place.at(rows.at(static_cast<std::size_t>(*key))); };
    get_memories(in, name + ".memory", contacts.memories(), 1, row);
    if constexpr (requires { contacts.work().last_forces(); }) {
      get_memories(in, name + ".last_force", contacts.work().last_forces(), 1, row);
    }
  });
}

}  // namespace detail

/// Writes the whole state of a system; call System::canonicalise() first, so that the run that goes on and the run that
/// is resumed take the same steps to the last bit.
template <class System>
void save(checkpoint_writer& out, const System& s) {
  const auto& g = s.particles();
  const auto view = s.view();
  out.put("system.composition", std::string_view{detail::composition<System>()});
  out.put("system.steps", s.step_count());
  out.put("system.grains", static_cast<std::uint64_t>(g.size()));
  detail::for_each_column<typename System::grains_type>(
      [&](const std::string& name, auto column) { out.put(name, detail::by_id<decltype(column)>(g)); });
  const auto pair_key = [&](std::size_t p, std::vector<std::int64_t>& keys) {
    keys.insert(keys.end(), {view.id[view.grain_i(p)], view.id[view.grain_j(p)]});
  };
  detail::put_memories(out, "pair.memory", s.contacts().memories(), view.pairs, pair_key);
  if constexpr (System::material_type::keeps_energy_book) {
    detail::put_memories(out, "pair.last_force", s.contacts().work().last_forces(), view.pairs, pair_key);
  }
  const auto work = s.contacts().work().total();
  out.put("pair.work", std::vector<double>{work.damping, work.friction});
  if constexpr (System::wet) detail::put_liquid(out, s);
  detail::put_walls(out, s);
}

/// Puts the state back into a system of the same composition that has no grains yet.
/// Errors: std::runtime_error for a checkpoint of another composition.
template <class System>
void load(const checkpoint_reader& in, System& s) {
  if (in.get<std::string>("system.composition") != detail::composition<System>()) {
    throw std::runtime_error("the checkpoint was written by a scene of other laws, protocol or walls: resume with the "
                             "options it was started with");
  }
  detail::get_grains(in, s.particles());
  detail::get_walls(in, s);
  const auto work = in.get<std::vector<double>>("pair.work");
  s.contacts().work().restore({work.at(0), work.at(1)});
  detail::list_again(in, s);
  const auto rows = s.particles().rows_by_id();
  if constexpr (System::wet) detail::get_liquid(in, s, rows);
  const auto view = s.view();
  const auto pair_row = [&](const std::int64_t* key) { return detail::pair_of(s, view, rows, key); };
  detail::get_memories(in, "pair.memory", s.contacts().memories(), 2, pair_row);
  if constexpr (System::material_type::keeps_energy_book) {
    detail::get_memories(in, "pair.last_force", s.contacts().work().last_forces(), 2, pair_row);
  }
  detail::get_wall_memories(in, s, rows);
}

}  // namespace pendular::io
