// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../catch.hpp"
#include "exact.hpp"
#include "examples.hpp"

#include <pendular/testing/law_kits.hpp>

#include <boost/hana/for_each.hpp>

#include <typeinfo>

// Every shipped law in every scalar, against the law itself in fifty digits: what is tested is the arithmetic, not the
// physics. Errors are relative to the exact value. Each law is compiled in six scalars: hence several sources, none of
// which takes long to compile.
namespace every_scalar {
using namespace pendular;
namespace hana = boost::hana;
using eight_doubles = lanes<8>;
using sixteen_floats = lanes<16, float>;

/// In fifty digits.
template <class Input, class Evaluate>
std::vector<double> exact_values(const std::vector<Input>& samples, const Evaluate& evaluate) {
  std::vector<double> values;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    values.push_back(static_cast<double>(exact(evaluate(testing::gathered<exact>(samples, k)))));
  }
  return values;
}

/// `evaluate(input<T>) -> T` in T against the exact values; the exponential of a hundred costs two digits.
template <class T, class Input, class Evaluate>
void check_digits(const std::vector<Input>& samples, const std::vector<double>& exact_value, const Evaluate& evaluate,
                  double granted) {
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t first = 0; first < samples.size(); first += testing::width<T>) {
    const T result = evaluate(testing::gathered<T>(samples, first));
    for (std::size_t lane = 0; lane < testing::width<T>; ++lane) {
      const std::size_t k = (first + lane) % samples.size();
      const double expected = exact_value[k];
      const double error = std::abs(testing::number(result, lane) - expected);
      const double relative = error / std::max(std::abs(expected), testing::granted_zero<T>);
      if (!(relative <= worst)) worst = relative, at = k;
    }
  }
  CAPTURE(typeid(T).name(), at, worst);
  CHECK(worst <= granted);
}

template <class Input, class Evaluate>
void check_every_scalar(const std::vector<Input>& samples, const Evaluate& evaluate, double in_double = 1e-13,
                        double in_float = 1e-4) {
  const std::vector<double> expected = exact_values(samples, evaluate);
  check_digits<double>(samples, expected, evaluate, in_double);
  check_digits<dual>(samples, expected, evaluate, in_double);
  check_digits<eight_doubles>(samples, expected, evaluate, in_double);
  check_digits<float>(samples, expected, evaluate, in_float);
  check_digits<sixteen_floats>(samples, expected, evaluate, in_float);
}

template <class List, class Use>
void for_each_law(List laws, const Use& use) {
  hana::for_each(laws, [&]<class L>(L) {
    using law = typename L::type;
    INFO(typeid(law).name());
    use(examples::of<law>::value);
  });
}

inline std::vector<bridge<double>> with_dry_bridges(const validity& law) {
  std::vector<bridge<double>> samples = testing::bridge_samples(law);
  for (const double gap : {-1e-6, 0.0, 1e-5}) {
    for (const double volume : {0.0, 1e-25, 1e-18}) samples.push_back({gap, volume, 5e-4, 1e-3});
  }
  return samples;
}

template <class List>
void check_pulls(List laws) {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    for_each_law(laws, [&]<class L>(const L& law) {
      const auto pull = [&]<class T>(const bridge<T>& b) { return T(testing::pull(law, b, f)); };
      if constexpr (requires { L::float_error; }) {
        check_every_scalar(testing::bridge_samples(validity_of<L>()), pull, 1e-11, L::float_error);
      } else {
        check_every_scalar(with_dry_bridges(validity_of<L>()), pull, 1e-13, 1e-4);
      }
    });
  }
}
}  // namespace every_scalar
