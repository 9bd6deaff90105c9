// SPDX-License-Identifier: BSD-3-Clause
#include "every_scalar.hpp"

using namespace every_scalar;

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
