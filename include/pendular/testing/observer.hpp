// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/motion/check.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/testing/report.hpp>

#include <cstdint>
#include <exception>
#include <string>

namespace pendular::testing {

namespace detail {
template <class System>
void demand_same_motion(report& broken, const System& watched, const System& alone) {
  const auto rows = watched.particles().rows_by_id();
  const auto others = alone.particles().rows_by_id();
  for (std::size_t k = 0; k < rows.size() && k < others.size(); ++k) {
    const vector& here = watched.particles().template get<column::position>()[rows[k]];
    const vector& there = alone.particles().template get<column::position>()[others[k]];
    demand(broken, here == there, "being watched must not change a bit",
           {{"grain", static_cast<double>(k)}, {"watched", norm(here)}, {"alone", norm(there)}});
  }
}
}  // namespace detail

/// What an observer promises beyond its signature, while it watches a copy of a scene of the user's for some steps: best
/// one in which bridges form and break. A copy of the observer is used.
template <class System, Observer<System> O>
report observer_report(O observer, const System& scene, std::int64_t steps = 100) {
  static_assert(check::observer<O, System>);
  report broken;
  if constexpr (requires { observer.period; }) {
    demand(broken, observer.period > 0, "the period must be at least 1", {{"period", double(observer.period)}});
    if (!broken.empty()) return broken;
  }
  System watched = scene, alone = scene;
  alone.run(steps);
  try {
    watched.run(steps, observer);
  } catch (const std::exception& e) {
    demand(broken, false, "an observer of a sound scene must not throw (" + std::string(e.what()) + ")",
           {{"step", static_cast<double>(watched.step_count())}});
    return broken;
  }
  detail::demand_same_motion(broken, watched, alone);
  return broken;
}

}  // namespace pendular::testing
