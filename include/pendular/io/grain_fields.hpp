// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/io/vtk.hpp>
#include <pendular/space/grains.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pendular::io {

namespace detail {
/// Label and unit of a column, as a field is called.
template <class Column>
std::string field_name() {
  const std::string label{Column::label}, unit{Column::unit};
  return unit == "1" ? label : label + " (" + unit + ")";
}

template <class Column, class Grains>
field field_of(const Grains& g) {
  field f{field_name<Column>(), std::is_same_v<typename Column::type, vector> ? 3 : 1, std::vector<double>{}};
  for (const std::size_t row : g.rows_by_id()) {
    const auto& value = g.template get<Column>()[row];
    if constexpr (std::is_same_v<typename Column::type, std::int64_t>) {
      f.values.push_back(static_cast<double>(value));
    } else {
      for_each_scalar<double>(value, [&](const double& v) { f.values.push_back(v); });
    }
  }
  return f;
}
}  // namespace detail

/// Every column of the grains, tags of one's own included, as fields under label and unit, in the order of ids.
template <class Grains>
std::vector<field> grain_fields(const Grains& g) {
  std::vector<field> fields{detail::field_of<pendular::column::id>(g)};
  Grains::for_each_column([&](auto column) {
    if constexpr (!std::is_same_v<decltype(column), pendular::column::position>) {
      fields.push_back(detail::field_of<decltype(column)>(g));
    }
  });
  return fields;
}

/// All grains with all their columns as points for ParaView (.vtp). Errors: as write_points.
template <class Grains>
void write_grains(const std::filesystem::path& path, const Grains& g) {
  std::vector<double> x, y, z;
  for (const std::size_t row : g.rows_by_id()) {
    const vector& p = g.template get<pendular::column::position>()[row];
    x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
  }
  write_points(path, x, y, z, grain_fields(g));
}

}  // namespace pendular::io
