// SPDX-License-Identifier: BSD-3-Clause

// Energy under both integrators: kept in elastic contacts, and booked in a sheared packing.
#include "integrator_energy.hpp"

#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

using namespace integrator_energy;

TEST_CASE("an elastic pair keeps its energy over thousands of periods to second order, under both integrators alike") {
  boost::hana::for_each(boost::hana::tuple_t<velocity_verlet, half_step_velocity_verlet>, [](auto type) {
    using integration = typename decltype(type)::type;
    const swing coarse = elastic_pair<integration>(25, 2000), fine = elastic_pair<integration>(50, 2000);
    CAPTURE(coarse.early, coarse.late, fine.early, fine.late);
    CHECK(coarse.early < 3e-5);
    CHECK(coarse.late < 1.01 * coarse.early);
    CHECK(coarse.early / fine.early == near(0.1, 4.0));
  });
}

TEST_CASE("the energy book of a sheared packing closes to second order, closest with half-step velocities") {
  const double synchronised = sheared_packings<velocity_verlet>(50, 2).imbalance;
  const double half_step = sheared_packings<half_step_velocity_verlet>(50, 2).imbalance;
  CAPTURE(synchronised, half_step);
  CHECK(synchronised < 2e-3);
  CHECK(half_step < 6e-4);
  CHECK(half_step < 0.6 * synchronised);
  CHECK(sheared_packings<velocity_verlet>(100, 2).imbalance == within(0.4, synchronised / 4));
  CHECK(sheared_packings<half_step_velocity_verlet>(100, 2).imbalance == within(0.4, half_step / 4));
}
