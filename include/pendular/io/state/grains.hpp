// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/io/state/records.hpp>
#include <pendular/motion/driven_grains.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular::io::detail {

/// The number of which a column's values are made.
template <class Column>
using number_of = std::conditional_t<std::is_same_v<typename Column::type, std::int64_t>, std::int64_t, double>;

/// Rows of a column in the order of the grains' ids, as plain numbers.
template <class Column, class Grains>
std::vector<number_of<Column>> by_id(const Grains& g) {
  std::vector<number_of<Column>> flat;
  for (const std::size_t row : g.rows_by_id()) {
    for_each_scalar<number_of<Column>>(g.template get<Column>()[row],
                                       [&](const number_of<Column>& v) { flat.push_back(v); });
  }
  return flat;
}

template <class Column, class Grains>
void fill(Grains& g, const std::vector<number_of<Column>>& flat) {
  std::size_t k = 0;
  for (auto& row : g.template get<Column>()) {
    for_each_scalar<number_of<Column>>(row, [&](number_of<Column>& v) { v = flat[k++]; });
  }
}

/// Rows of grains by their ids.
class row_index {
 public:
  template <class Grains>
  explicit row_index(const Grains& g) {
    for (const std::size_t row : g.rows_by_id()) rows_.push_back({g.template get<pendular::column::id>()[row], row});
  }
  /// Errors: std::runtime_error.
  std::size_t at(std::int64_t id) const {
    const auto found = std::lower_bound(rows_.begin(), rows_.end(), id,
                                        [](const auto& entry, std::int64_t wanted) { return entry.first < wanted; });
    if (found != rows_.end() && found->first == id) return found->second;
    refuse_content("it has something of grain " + std::to_string(id) + ", which is not among its grains");
  }

 private:
  std::vector<std::pair<std::int64_t, std::size_t>> rows_;
};

/// The name under which a column is kept.
template <class Column>
std::string record_of() {
  return "grain." + std::string(Column::label);
}

/// Grains whose motion is prescribed: ids, both velocities, and the work that it has done.
inline void put_driven(checkpoint_writer& out, const driven_grains& driven) {
  std::vector<std::int64_t> ids;
  std::vector<double> motions;
  for (const driven_grain& d : driven.all()) {
    ids.push_back(d.id);
    for (const vector& v : {d.velocity, d.angular_velocity}) motions.insert(motions.end(), {v.x, v.y, v.z});
  }
  out.put("driven.ids", ids);
  out.put("driven.motions", motions);
  out.put("driven.work", driven.work());
}
template <class System>
void get_driven(const checkpoint_reader& in, System& s) {
  const auto ids = in.get<std::vector<std::int64_t>>("driven.ids");
  const auto m = in.get<std::vector<double>>("driven.motions", 6 * ids.size());
  std::vector<driven_grain> all;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const auto three = [&](std::size_t at) { return vector{m[at], m[at + 1], m[at + 2]}; };
    all.push_back({ids[k], three(6 * k), three(6 * k + 3)});
  }
  s.restore_driven(std::move(all), in.get<double>("driven.work"));
}

/// Ids that rise from 0 or more to less than the next one.
inline void expect_ids(const std::vector<std::int64_t>& ids, std::int64_t next_id) {
  std::int64_t last = -1;
  for (const std::int64_t id : ids) {
    if (id <= last || id >= next_id) refuse_content("grain " + std::to_string(id) + " is where it cannot be");
    last = id;
  }
}

template <class Grains>
void get_grains(const checkpoint_reader& in, Grains& g) {
  const auto ids = in.get<std::vector<std::int64_t>>("grain.id");
  const auto next_id = in.get<std::int64_t>("system.next_id");
  if (ids.empty()) refuse_content("it has no grains");
  expect_ids(ids, next_id);
  g.restore(ids, next_id);
  Grains::for_each_column([&](auto column) {
    using tag = decltype(column);
    constexpr std::size_t width = sizeof(typename tag::type) / sizeof(number_of<tag>);
    fill<tag>(g, in.get<std::vector<number_of<tag>>>(record_of<tag>(), width * ids.size()));
  });
  for (const double inverse : g.template get<pendular::column::inverse_mass>()) {
    if (!(inverse > 0 && std::isfinite(inverse))) refuse_content("a grain has a mass that is none");
  }
}

}  // namespace pendular::io::detail
