// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/io/state/rows.hpp>
#include <pendular/liquid/ledger.hpp>
#include <pendular/liquid/pair_view.hpp>
#include <pendular/liquid/selection.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pendular::io::detail {

/// Accounts outside of the scene: names, one per line, and what each holds, as a sum without a rest.
inline void put_outside(checkpoint_writer& out, const ledger::books& books) {
  std::string names;
  std::size_t k = 0;
  for (const auto& account : books.outside) {
    names += account.name + '\n';
    put_sum(out, "liquid.outside." + std::to_string(k++), account.volume);
  }
  out.put("liquid.outside_names", std::string_view{names});
}
inline std::vector<ledger::outside_account> get_outside(const checkpoint_reader& in) {
  std::istringstream names(in.get<std::string>("liquid.outside_names"));
  std::vector<ledger::outside_account> accounts;
  for (std::string name; std::getline(names, name);) accounts.push_back({name});
  for (std::size_t k = 0; k < accounts.size(); ++k) {
    accounts[k].volume = get_sum(in, "liquid.outside." + std::to_string(k));
  }
  return accounts;
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
  put_sum(out, "liquid.reservoir", books.reservoir);
  out.put("liquid.introduced", books.introduced);
  put_sum(out, "liquid.work", s.bridges().work_sum());
  put_outside(out, books);
  const auto& outside = s.bridges().outside();
  out.put("liquid.outside", std::vector<std::int64_t>{outside.capillary_law, outside.rupture_law});
  out.put("liquid.reach", s.bridges().reach(view));
  const auto& selection = s.selection();
  out.put("liquid.selection", std::vector<double>{selection.thinning, selection.widest_gap, selection.film_thickness});
  out.put("liquid.seed", selection.seed);
  out.put("liquid.asks_protocol", std::uint64_t{s.bridges().asks_protocol()});
  out.put("liquid.events", std::vector<std::int64_t>{s.events().ruptures, s.events().formations});
}

/// Row of the bonds with this key, whose second number is negative for a wall.
template <class System>
std::size_t bond_row_of(const System& s, const pair_view& view, const row_index& rows, const std::int64_t* key) {
  if (key[1] >= 0) return pair_of(s, view, rows, key);
  std::size_t found = view.rows();
  view.for_each_wall_row_of(rows.at(key[0]), [&](std::size_t p) {
    if (view.ids(p).second == key[1]) found = p;
  });
  if (found < view.rows()) return found;
  refuse_content("it has a bridge of grain " + std::to_string(key[0]) + " to wall " + std::to_string(-1 - key[1]) +
                 ", which it is not near");
}

inline void expect_volume(const std::string& of_what, double volume) {
  if (!(volume >= 0 && std::isfinite(volume))) {
    refuse_content(of_what + " has " + pendular::detail::number(volume) + " m3 of liquid");
  }
}

/// Films, selection and counts; bridges are put back once the pairs are listed.
template <class System>
void get_films(const checkpoint_reader& in, System& s) {
  auto& bridges = s.rows().bridges();
  const auto films = in.get<std::vector<double>>("liquid.films", s.particles().size());
  bridges.resize_films(films.size());
  for (std::size_t k = 0; k < films.size(); ++k) {
    expect_volume("a film", films[k]);
    bridges.restore_film(k, films[k]);
  }
  const auto events = in.get<std::vector<std::int64_t>>("liquid.events", 2);
  const auto selection = in.get<std::vector<double>>("liquid.selection", 3);
  const bond_selection chosen{selection[0], in.get<std::uint64_t>("liquid.seed"), selection[1], selection[2]};
  validate(chosen);
  bridges.select(chosen);
  for (const std::int64_t count : events) expect_count("ruptures or formations", count);
  bridges.restore_events({events[0], events[1]});
  bridges.ask_protocol(in.get<std::uint64_t>("liquid.asks_protocol") != 0);
}

template <class System>
void get_bridges(const checkpoint_reader& in, System& s, const row_index& rows) {
  auto& bridges = s.rows().bridges();
  const auto keys = get_keys<std::int64_t>(in, "liquid.keys", 2);
  const auto volumes = in.get<std::vector<double>>("liquid.volumes", keys.size() / 2);
  const auto view = s.view();
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    expect_volume("a bridge", volumes[n]);
    bridges.restore(bond_row_of(s, view, rows, keys.data() + 2 * n), volumes[n], view);
  }
  const auto introduced = in.get<double>("liquid.introduced");
  if (!std::isfinite(introduced)) refuse_content("it has no finite volume of liquid");
  bridges.restore_books({get_sum(in, "liquid.reservoir"), introduced, get_outside(in)});
  bridges.restore_work(get_sum(in, "liquid.work"));
  const double here = bridges.book().here(), counted = bridges.book().total();
  if (!(std::abs(counted - here) <= 1e-6 * std::max(std::abs(here), std::abs(bridges.book().introduced())))) {
    refuse_content("films and bridges hold " + pendular::detail::number(counted) + " m3, and its books say " +
                   pendular::detail::number(here));
  }
  const auto outside = in.get<std::vector<std::int64_t>>("liquid.outside", 2);
  for (const std::int64_t count : outside) expect_count("bridges outside of the validity of their laws", count);
  bridges.restore_outside({outside[0], outside[1]});
}

}  // namespace pendular::io::detail
