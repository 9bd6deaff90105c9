// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace pendular {

namespace detail {
inline std::string at_step(std::int64_t id, std::int64_t step) {
  return "grain " + std::to_string(id) + " at step " + std::to_string(step);
}

/// Throws if the contact of a grain with `other` is not as it must be. `gap` and `radius`, the smaller one, in m.
inline void expect_sound(std::int64_t id, const std::string& other, double gap, double radius, const vector& force,
                         double overlap_limit, std::int64_t step) {
  const bool shallow = gap > -overlap_limit * radius;
  if (shallow && std::isfinite(dot(force, force))) return;
  const std::string grain = at_step(id, step);
  const std::string page = " (see docs/how-to/stability.md)";
  if (!std::isfinite(gap)) {
    throw run_error(grain + " and " + other +
                    " have a gap that is not finite: their centres coincide, or a position or shape is not finite" +
                    page);
  }
  if (shallow) {
    throw run_error(grain + " and " + other + " at a gap of " + number(gap) +
                    " m got a force that is not finite from a contact law: check its parameters and its limits" + page);
  }
  throw run_error(grain + " overlaps " + other + " by " + number(-gap / radius) +
                  " of its radius, more than the limit of " + number(overlap_limit) +
                  ": the contact is too soft for the load or the step too long" + page);
}
}  // namespace detail

/// Finds and reports what an evaluation only noticed, if it was a pair.
template <class Grains, class Contacts>
void report_pair_trouble(const Grains& g, const pair_list& list, const Contacts& contacts, double overlap_limit,
                         std::int64_t step) {
  const auto radius = g.template get<column::radius>();
  const auto id = g.template get<column::id>();
  for (std::size_t p = 0; p < list.size(); ++p) {
    const auto i = static_cast<std::size_t>(list.first()[p]), j = static_cast<std::size_t>(list.second()[p]);
    detail::expect_sound(id[i], "grain " + std::to_string(id[j]), contacts.gap()[p], std::min(radius[i], radius[j]),
                         contacts.force(p), overlap_limit, step);
  }
}

/// The same for a wall, the one of this number, from 0.
template <class Grains, class WallContacts>
void report_wall_trouble(const Grains& g, const WallContacts& contacts, std::size_t wall, double overlap_limit,
                         std::int64_t step) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::size_t row = contacts.row(k);
    detail::expect_sound(g.template get<column::id>()[row], "wall " + std::to_string(wall), contacts.gap(k),
                         g.template get<column::radius>()[row], contacts.force(k), overlap_limit, step);
  }
}

/// What neither of them finds.
[[noreturn]] inline void report_hidden_trouble(std::int64_t step) {
  throw run_error("a law returned a value that is not finite at step " + std::to_string(step) +
                  " for a contact without force (see docs/how-to/stability.md)");
}

}  // namespace pendular
