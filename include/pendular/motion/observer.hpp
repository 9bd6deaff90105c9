// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/none.hpp>
#include <pendular/liquid/bridge_event.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

/// Looks at nothing, and costs nothing.
using null_observer = none;

/// Is called with the system after every step, or after every `period` steps if it has one.
template <class O, class System>
concept ObservesSteps = requires(O& observer, const System& s) {
  observer(s);
};

/// Is told of every bridge that formed or ended, after the step in which it did, in the order of ids.
template <class O>
concept ObservesEvents = requires(O& observer, const bridge_event& event) {
  observer.notice(event);
};

template <class O, class System>
concept Observer = std::is_same_v<O, null_observer> || ObservesEvents<O> || ObservesSteps<O, System>;

/// A callable that looks after every so many steps.
template <class Look>
struct every {
  std::int64_t period;  // steps
  Look look;

  every(std::int64_t steps, Look l) : period(steps), look(std::move(l)) {}
  template <class System>
    requires(std::invocable<Look&, const System&>)
  void operator()(const System& s) { look(s); }
};

namespace detail {
template <class System, class O>
bool looks_at_step(const O& observer, std::int64_t step) {
  if constexpr (!ObservesSteps<O, System>) {
    return false;
  } else if constexpr (requires { observer.period; }) {
    return step % observer.period == 0;
  } else {
    return true;
  }
}

/// Errors: a period that is none.
template <class O>
void expect_period(const O& observer) {
  if constexpr (requires { observer.period; }) {
    expects(observer.period > 0, "the period of an observer (steps)", static_cast<double>(observer.period),
            "at least 1", "docs/reference/observe.md");
  }
}

/// What happened in the last step of a system, to whoever asks for it.
template <class O, class System>
void tell(O& observer, const System& s, std::vector<bridge_event> events) {
  if constexpr (ObservesEvents<O>) {
    std::stable_sort(events.begin(), events.end(),
                     [](const bridge_event& a, const bridge_event& b) { return a.ids < b.ids; });
    for (bridge_event& e : events) {
      e.step = s.step_count();
      observer.notice(std::as_const(e));
    }
  }
  if constexpr (ObservesSteps<O, System>) {
    if (looks_at_step<System>(observer, s.step_count())) observer(s);
  }
}
}  // namespace detail

}  // namespace pendular
