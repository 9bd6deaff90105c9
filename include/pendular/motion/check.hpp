// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/core/never.hpp>
#include <pendular/motion/observer.hpp>
#include <pendular/motion/velocity_verlet.hpp>

#include <concepts>
#include <cstdint>

namespace pendular::check {

// Ladders as those of laws (law/check.hpp): true, or one sentence for the first clause that is broken.

namespace detail {
using namespace pendular::detail;

template <class I>
concept HasTimeStepAndGravity = requires(const I integrator) {
  { integrator.time_step } -> std::convertible_to<double>;
  { integrator.gravity } -> std::convertible_to<vector>;
};
template <class I>
concept Predicts = requires(const I integrator, vector& changed, const vector a) {
  integrator.predict(changed, changed, a);
  integrator.predict_spin(changed, a);
};
template <class I>
concept Corrects = requires(const I integrator, vector& changed, const vector a) {
  integrator.correct(changed, a, a);
};
template <class I>
concept KnowsItsLimit = requires {
  { I::stable_step(1.0, 1.0) } -> std::convertible_to<double>;
};
}  // namespace detail

template <class I>
consteval bool is_integrator() {
  if constexpr (!Copyable<I>) {
    static_assert(detail::never<I>, "an integrator must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!detail::HasTimeStepAndGravity<I>) {
    static_assert(detail::never<I>, "an integrator needs the members `double time_step` and `vector gravity` "
                                    "(docs/reference/integrators.md)");
  } else if constexpr (!detail::Predicts<I>) {
    static_assert(
        detail::never<I>,
        "an integrator needs `void predict(vector& position, vector& velocity, const vector& acceleration) "
        "const` and `void predict_spin(vector& spin, const vector& acceleration) const`, or templates of them "
        "(docs/reference/concepts.md)");
  } else if constexpr (!detail::Corrects<I>) {
    static_assert(
        detail::never<I>,
        "an integrator needs `void correct(vector& velocity, const vector& before, const vector& now) const`, "
        "or a template of it (docs/reference/concepts.md)");
  } else if constexpr (!detail::KnowsItsLimit<I>) {
    static_assert(detail::never<I>, "an integrator needs `static double stable_step(double omega2, double rate)`, its "
                                    "largest stable step (docs/reference/concepts.md)");
  } else if constexpr (!Integrator<I>) {
    static_assert(detail::never<I>,
                  "an integrator needs `static constexpr double velocity_lag`, the steps by which the "
                  "velocities that forces see are old (docs/reference/concepts.md)");
  }
  return true;
}

template <class O, class System>
consteval bool is_observer() {
  if constexpr (Observer<O, System>) {
    if constexpr (requires(const O& o) { o.period; }) {
      static_assert(
          requires(const O& o) {
            { o.period } -> std::convertible_to<std::int64_t>;
          },
          "the period of an observer is a number of steps (docs/reference/observe.md)");
    }
  } else if constexpr (requires(O & o, System & s) { o(s); }) {
    static_assert(detail::never<O>, "an observer looks at a scene and does not change it: take the system by a "
                                    "reference to const (docs/reference/observe.md)");
  } else {
    static_assert(detail::never<O>,
                  "an observer is called with `const system&`, or has a `notice(const bridge_event&)`, or both "
                  "(docs/reference/observe.md)");
  }
  return true;
}

template <class I>
inline constexpr bool integrator = is_integrator<I>();
template <class O, class System>
inline constexpr bool observer = is_observer<O, System>();

}  // namespace pendular::check
