// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/core/lanes.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/law/stiffness.hpp>
#include <pendular/testing/report.hpp>

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace pendular::testing {

/// How many samples one T carries.
template <class T>
inline constexpr std::size_t width = 1;
template <pendular::detail::Lanes T>
inline constexpr std::size_t width<T> = static_cast<std::size_t>(T::width);

/// One T from as many samples as it has lanes, `field(first)` onwards.
template <class T, class Field>
T gathered(std::size_t first, const Field& field) {
  if constexpr (pendular::detail::Lanes<T>) {
    return T::from([&](int k) { return field(first + static_cast<std::size_t>(k)); });
  } else {
    return T(field(first));
  }
}

template <class T>
double number(const T& x, std::size_t lane = 0) {
  if constexpr (pendular::detail::Lanes<T>) {
    return static_cast<double>(x[static_cast<int>(lane)]);
  } else if constexpr (std::is_same_v<T, dual>) {
    return x.value();
  } else {
    return static_cast<double>(x);
  }
}

template <class T>
approach<T> gathered(const std::vector<approach<double>>& samples, std::size_t first) {
  const auto of = [&](double approach<double>::*member) {
    return gathered<T>(first, [&](std::size_t k) { return samples[k % samples.size()].*member; });
  };
  using a = approach<double>;
  return {of(&a::gap), of(&a::closing_speed), of(&a::reduced_mass), of(&a::radius_i), of(&a::radius_j)};
}

template <class T>
bridge<T> gathered(const std::vector<bridge<double>>& samples, std::size_t first) {
  const auto of = [&](double bridge<double>::*member) {
    return gathered<T>(first, [&](std::size_t k) { return samples[k % samples.size()].*member; });
  };
  using b = bridge<double>;
  return {of(&b::gap), of(&b::volume), of(&b::radius_i), of(&b::radius_j)};
}

/// Samples that share a time step must be passed together.
template <class T>
slip<T> gathered(const std::vector<slip<double>>& samples, std::size_t first) {
  const auto of = [&](auto member) {
    return gathered<T>(first, [&](std::size_t k) { return member(samples[k % samples.size()]); });
  };
  using s = slip<double>;
  return {{of([](const s& x) { return x.velocity.x; }), of([](const s& x) { return x.velocity.y; }),
           of([](const s& x) { return x.velocity.z; })},
          {of([](const s& x) { return x.normal.x; }), of([](const s& x) { return x.normal.y; }),
           of([](const s& x) { return x.normal.z; })},
          of([](const s& x) { return x.tangential_mass; }),
          of([](const s& x) { return x.contacts; }),
          samples.front().time_step};
}

/// What a law without history remembers: zeros. Eigen leaves a value-initialised AutoDiffScalar as it is.
template <class Memory, class T>
Memory fresh_memory() {
  Memory memory{};
  if constexpr (std::is_same_v<T, dual>) {
    std::memset(static_cast<void*>(&memory), 0, sizeof memory);
  }
  return memory;
}

template <class Memory>
bool is_zero(const Memory& memory) {
  bool zero = true;
  for_each_scalar<double>(memory, [&](double x) { zero = zero && x == 0; });
  return zero;
}

/// Relative error granted to a scalar: a float loses digits in an exponential of a hundred decay lengths.
template <class T>
inline constexpr double granted_error = std::is_same_v<element_t<T>, float> ? 2e-4 : 1e-11;
/// The same for a law, which may ask for more in float by a static member `float_error`.
template <class T, class Law>
constexpr double granted_error_of() {
  if constexpr (std::is_same_v<element_t<T>, float> && requires { Law::float_error; }) {
    return Law::float_error;
  } else {
    return granted_error<T>;
  }
}
/// Below this a float is zero or denormal.
template <class T>
inline constexpr double granted_zero = std::is_same_v<element_t<T>, float> ? tiny : 1e-290;

inline constexpr auto no_rounding = [](const auto&) { return 0.0; };

/// `evaluate(input<T>) -> T` must give what `evaluate(input<double>)` gives, lane by lane, up to a relative error and
/// what `rounding(input<double>)` allows.
template <class T, class Input, class Evaluate, class Rounding = decltype(no_rounding)>
void demand_same_in(report& broken, std::string_view property, const std::vector<Input>& samples,
                    const Evaluate& evaluate, double granted = granted_error<T>, const Rounding& rounding = {}) {
  for (std::size_t first = 0; first < samples.size(); first += width<T>) {
    const T result = evaluate(gathered<T>(samples, first));
    for (std::size_t lane = 0; lane < width<T>; ++lane) {
      const std::size_t k = (first + lane) % samples.size();
      const double expected = evaluate(samples[k]);
      const double found = number(result, lane);
      demand(broken, agree(found, expected, granted, std::max(rounding(samples[k]), granted_zero<T>)), property,
             {{"sample", double(k)}, {"found", found}, {"in double", expected}});
    }
  }
}

}  // namespace pendular::testing
