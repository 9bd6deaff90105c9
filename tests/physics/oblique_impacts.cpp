// SPDX-License-Identifier: BSD-3-Clause

// Both integrators on oblique impacts and on an incline against closed forms: Chung and Ooi 2011, tests 4 to 8, in
// gross sliding with linear springs, and an impact that sticks throughout.
#include "integrator_scenes.hpp"

#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

using namespace integrator_scenes;

namespace {
constexpr auto both = boost::hana::tuple_t<velocity_verlet, half_step_velocity_verlet>;
}  // namespace

TEST_CASE("Chung and Ooi 4 and 5 in gross sliding: both integrators, linear springs, coarse steps") {
  boost::hana::for_each(both, [](auto type) {
    using integration = typename decltype(type)::type;
    for (const impact& c : {chung_4(40), chung_4(60), chung_4(85), chung_5(2.5), chung_5(4), chung_5(10)}) {
      const impact_errors coarse = sliding_impact<integration>(c, 25), fine = sliding_impact<integration>(c, 200);
      CAPTURE(integration::velocity_lag, c.mu, c.sideways, coarse.normal, coarse.friction, fine.normal, fine.friction);
      CHECK(coarse.normal < 4e-4);
      CHECK(coarse.friction < 2e-3);
      CHECK(fine.normal < 5e-6);
      CHECK(fine.friction < 4e-4);  // what is left is the overlap, which shortens the lever arms
    }
  });
}

TEST_CASE("Chung and Ooi 6 to 8 in gross sliding: both integrators, spins, a pair, a size ratio of 5") {
  boost::hana::for_each(both, [](auto type) {
    using integration = typename decltype(type)::type;
    for (const impact& c : {chung_6(3), chung_6(6), chung_7(5, 1), chung_8(5)}) {
      const impact_errors coarse = sliding_impact<integration>(c, 50), fine = sliding_impact<integration>(c, 200);
      CAPTURE(integration::velocity_lag, c.second_radius, coarse.normal, coarse.friction, fine.normal, fine.friction);
      // The jump of the dashpot at first touch is met up to a step too late, whatever the integrator.
      CHECK(coarse.normal < 1.3e-2);
      CHECK(coarse.friction < 1.6e-2);
      CHECK(fine.normal < 3.5e-3);
      CHECK(fine.friction < 4.5e-3);
      CHECK(fine.friction < 0.4 * coarse.friction);
    }
    const impact_errors geared = sliding_impact<integration>(chung_7(5, -1), 50);
    CHECK(geared.friction < 1e-12);
    CHECK(geared.normal < 1.3e-2);
  });
}

TEST_CASE(
    "an impact that sticks turns its slip round with half-step velocities and loses some with synchronised ones") {
  for (const double steps : {25.0, 50.0, 100.0, 200.0}) {
    const double synchronised = sticking_impact<velocity_verlet>(steps);
    CAPTURE(steps, synchronised);
    CHECK(sticking_impact<half_step_velocity_verlet>(steps) < 2.5e-4);
    // The spring is charged with the velocity of the end of the step, half a step ahead of the mean: a dashpot
    // k_t dt / 2 beside it, whose restitution is exp(-pi omega dt / 4) with omega dt = pi / steps.
    CHECK(1 - synchronised == near(3e-3, std::exp(-pi * pi / (4 * steps))));
  }
}

TEST_CASE("both integrators roll and slide down an incline, and creep by Eq. 12 where rotation is blocked") {
  boost::hana::for_each(both, [](auto type) {
    using integration = typename decltype(type)::type;
    for (const double steps : {25.0, 100.0}) {
      CAPTURE(integration::velocity_lag, steps);
      for (const double degrees : {20.0, 30.0, 45.0, 60.0}) CHECK(incline<integration>(degrees, steps) < 1.2e-3);
      for (const double gamma : {0.1, 1.0, 100.0}) CHECK(creep<integration>(gamma, steps) < 1e-10);
    }
  });
}
