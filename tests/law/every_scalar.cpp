// SPDX-License-Identifier: BSD-3-Clause
// Every shipped law in every scalar, against the law itself in fifty digits: what is tested is the arithmetic, not the
// physics. Errors are relative to the exact value.
#include "../catch.hpp"
#include "examples.hpp"

#include <pendular/testing/law_kits.hpp>

#include <boost/hana/for_each.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <typeinfo>

using namespace pendular;
namespace hana = boost::hana;

namespace {
using exact = boost::multiprecision::cpp_bin_float_50;
using eight_doubles = lanes<8>;
using sixteen_floats = lanes<16, float>;

/// `evaluate(input<T>) -> T` in T against fifty digits; the exponential of a hundred costs two digits.
template <class T, class Input, class Evaluate>
void check_digits(const std::vector<Input>& samples, const Evaluate& evaluate, double granted) {
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t first = 0; first < samples.size(); first += testing::width<T>) {
    const T result = evaluate(testing::gathered<T>(samples, first));
    for (std::size_t lane = 0; lane < testing::width<T>; ++lane) {
      const std::size_t k = (first + lane) % samples.size();
      const double expected = static_cast<double>(exact(evaluate(testing::gathered<exact>(samples, k))));
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
  check_digits<double>(samples, evaluate, in_double);
  check_digits<dual>(samples, evaluate, in_double);
  check_digits<eight_doubles>(samples, evaluate, in_double);
  check_digits<float>(samples, evaluate, in_float);
  check_digits<sixteen_floats>(samples, evaluate, in_float);
}

template <class List, class Use>
void for_each_law(List laws, const Use& use) {
  hana::for_each(laws, [&]<class L>(L) {
    using law = typename L::type;
    INFO(typeid(law).name());
    use(examples::of<law>::value);
  });
}

std::vector<bridge<double>> with_dry_bridges(const validity& law) {
  std::vector<bridge<double>> samples = testing::bridge_samples(law);
  for (const double gap : {-1e-6, 0.0, 1e-5}) {
    for (const double volume : {0.0, 1e-25, 1e-18}) samples.push_back({gap, volume, 5e-4, 1e-3});
  }
  return samples;
}
}  // namespace

TEST_CASE("every normal law in every scalar") {
  for_each_law(law::normal_laws, [](const auto& law) {
    check_every_scalar(testing::approach_samples(), [&](const auto& a) { return law.repulsion(a); });
    check_every_scalar(testing::approach_samples(1e-6), [&](const auto& a) { return law.repulsion(a); });
    if constexpr (testing::detail::HasNormalEnergy<std::remove_cvref_t<decltype(law)>>) {
      check_every_scalar(testing::approach_samples(), [&](const auto& a) { return law.energy(a); });
    }
  });
}

TEST_CASE("every damping law in every scalar") {
  for_each_law(law::damping_laws, [](const auto& law) {
    check_every_scalar(testing::approach_samples(),
                       [&]<class T>(const approach<T>& a) { return testing::first_resistance(law, a, T(1e3)); });
  });
}

TEST_CASE("every friction law in every scalar") {
  for_each_law(law::friction_laws, [](const auto& law) {
    for (const double time_step : {1e-9, 1e-6, 1e-4}) {
      check_every_scalar(testing::slip_samples(time_step),
                         [&]<class T>(const slip<T>& s) { return testing::detail::dragged<T>(law, s); });
    }
  });
}

TEST_CASE("every capillary law in every scalar") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    for_each_law(law::capillary_laws, [&]<class L>(const L& law) {
      const auto pull = [&]<class T>(const bridge<T>& b) { return T(testing::pull(law, b, f)); };
      if constexpr (requires { L::float_error; }) {
        check_every_scalar(testing::bridge_samples(validity_of<L>()), pull, 1e-11, L::float_error);
      } else {
        check_every_scalar(with_dry_bridges(validity_of<L>()), pull, 1e-13, 1e-4);
      }
    });
  }
}

TEST_CASE("every capillary energy in every scalar") {
  for_each_law(law::capillary_laws, []<class L>(const L& law) {
    if constexpr (HasCapillaryEnergy<L>) {
      // rupture at 2^-10 m, the same number in every scalar and far enough not to cancel
      const auto energy = [&]<class T>(const bridge<T>& b) { return T(law.energy(b, fluid::water(), T(0x1p-10))); };
      check_every_scalar(testing::bridge_samples(validity_of<L>()), energy);
    }
  });
}

TEST_CASE("every rupture law in every scalar") {
  for (const fluid& f : {fluid::water(), examples::tilted_water}) {
    for_each_law(law::rupture_laws, [&]<class L>(const L& law) {
      check_every_scalar(with_dry_bridges(validity_of<L>()), [&](const auto& b) { return law.distance(b, f); });
    });
  }
}

TEST_CASE("a law in fifty digits is right in forty") {
  const normal::hertz law{1.5, 0.5};
  const approach<exact> a{exact("-0.0625"), 0, 1, 2, 2};
  const exact root = exact(law.stiffness(a)) / 2;  // of the overlap: a quarter
  CHECK(exact(pendular::abs(exact(root - exact("0.25")))) < exact("1e-45"));
  const bridge<exact> b{0, exact("1e-9"), exact("5e-4"), exact("5e-4")};
  const exact distance = rupture::lian{}.distance(b, fluid::water());
  CHECK(exact(pendular::abs(exact(distance - exact("1e-3")))) < exact("1e-45"));
}
