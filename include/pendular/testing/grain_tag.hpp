// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/space/check.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/testing/report.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace pendular::testing {

/// What a tag of grains promises beyond its signature: names that files can keep beside those of the library's columns.
template <GrainTag T>
report grain_tag_report() {
  static_assert(check::grain_tag<T>);
  constexpr std::array<std::string_view, 10> taken{column::position::label, column::radius::label,
                                                   column::velocity::label, column::inverse_mass::label,
                                                   column::force::label,    column::angular_velocity::label,
                                                   column::torque::label,   column::inverse_inertia::label,
                                                   column::contacts::label, column::id::label};
  report broken;
  const std::string_view label = T::label, unit = T::unit;
  const auto is_of_names = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  demand(broken, !label.empty() && std::all_of(label.begin(), label.end(), is_of_names),
         "the label must be made of letters, digits and underscores (" + std::string(label) + ")", {});
  demand(broken, std::find(taken.begin(), taken.end(), label) == taken.end(),
         "the label must not be that of a column of the library (" + std::string(label) + ")", {});
  const auto is_of_units = [](char c) { return std::isprint(static_cast<unsigned char>(c)) != 0 && c != '"'; };
  demand(broken, !unit.empty() && std::all_of(unit.begin(), unit.end(), is_of_units),
         "the unit must be there, \"1\" for a number (" + std::string(unit) + ")", {});
  return broken;
}

}  // namespace pendular::testing
