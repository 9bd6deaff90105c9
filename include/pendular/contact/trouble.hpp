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
}  // namespace detail

/// Finds and reports what an evaluation only noticed, if it was a pair.
template <class Grains, class Contacts>
void report_pair_trouble(const Grains& g, const pair_list& list, const Contacts& contacts, double overlap_limit,
                         std::int64_t step) {
  const auto gap = contacts.gap();
  const auto radius = g.template get<column::radius>();
  const auto id = g.template get<column::id>();
  for (std::size_t p = 0; p < list.size(); ++p) {
    const auto i = static_cast<std::size_t>(list.first()[p]), j = static_cast<std::size_t>(list.second()[p]);
    const double smaller = std::min(radius[i], radius[j]);
    const vector force = contacts.force(p);
    if (gap[p] > -overlap_limit * smaller && std::isfinite(dot(force, force))) continue;
    if (!std::isfinite(gap[p])) {
      throw run_error(detail::at_step(id[i], step) + " and grain " + std::to_string(id[j]) +
                      " have a gap that is not finite: their centres coincide or a position is not finite (see "
                      "docs/how-to/stability.md)");
    }
    if (gap[p] > -overlap_limit * smaller) {
      throw run_error(detail::at_step(id[i], step) + " and grain " + std::to_string(id[j]) + " at a gap of " +
                      detail::number(gap[p]) +
                      " m got a force that is not finite from a contact law: check its "
                      "parameters and its limits (see docs/how-to/stability.md)");
    }
    throw run_error(detail::at_step(id[i], step) + " overlaps grain " + std::to_string(id[j]) + " by " +
                    detail::number(-gap[p] / smaller) + " of its radius, more than the limit of " +
                    detail::number(overlap_limit) +
                    ": the contact is too soft for the load or the step too long (see "
                    "docs/how-to/stability.md)");
  }
}

/// The same for a wall.
template <class Grains, class WallContacts>
void report_wall_trouble(const Grains& g, const WallContacts& contacts, double overlap_limit, std::int64_t step) {
  const auto radius = g.template get<column::radius>();
  const auto id = g.template get<column::id>();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::size_t row = contacts.row(k);
    const double overlap = -contacts.gap(k) / radius[row];
    const vector& force = contacts.force(k);
    if (overlap < overlap_limit && std::isfinite(dot(force, force))) continue;
    throw run_error(detail::at_step(id[row], step) +
                    (std::isfinite(overlap) && overlap >= overlap_limit
                         ? " overlaps a wall by " + detail::number(overlap) +
                               " of its radius, more than the limit of " + detail::number(overlap_limit) +
                               ": the wall is too soft for the load or the step too long (see docs/how-to/stability.md)"
                         : " got a force that is not finite from a wall: check the wall's material and shape (see "
                           "docs/how-to/stability.md)"));
  }
}

/// What neither of them finds.
[[noreturn]] inline void report_hidden_trouble(std::int64_t step) {
  throw run_error("a law returned a value that is not finite at step " + std::to_string(step) +
                  " for a contact without force (see docs/how-to/stability.md)");
}

}  // namespace pendular
