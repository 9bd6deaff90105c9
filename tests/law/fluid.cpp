// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/law/inputs.hpp>

#include <limits>

using namespace pendular;

TEST_CASE("a liquid that cannot be is refused") {
  const fluid water = fluid::water();
  CHECK_NOTHROW(validate(water));
  const double infinity = std::numeric_limits<double>::infinity();
  const auto with = [&](double fluid::*member, double value) {
    fluid f = water;
    f.*member = value;
    return f;
  };
  CHECK_NOTHROW(validate(with(&fluid::contact_angle, 1.57)));
  CHECK_NOTHROW(validate(with(&fluid::viscosity, 0)));
  CHECK_THROWS_AS(validate(with(&fluid::surface_tension, 0)), input_error);
  CHECK_THROWS_AS(validate(with(&fluid::surface_tension, infinity)), input_error);
  CHECK_THROWS_AS(validate(with(&fluid::contact_angle, -0.1)), input_error);
  CHECK_THROWS_AS(validate(with(&fluid::contact_angle, 1.5708)), input_error);
  CHECK_THROWS_AS(validate(with(&fluid::density, -1)), input_error);
  CHECK_THROWS_AS(validate(with(&fluid::viscosity, std::nan(""))), input_error);
  CHECK_THROWS_WITH(validate(with(&fluid::contact_angle, 2)),
                    "the contact angle (rad) is 2, but must be in [0, pi/2) (see docs/reference/laws.md)");
}

TEST_CASE("the companion paper's capillary tension is that of its surface tension") {
  // Richefeu, Radjai, El Youssoufi, Eur. Phys. J. E 21, 359 (2006): kappa = 0.4 N/m at theta = 0 is 0.0637 N/m
  CHECK(capillary_tension({0.0637, 0, 1000, 1e-3}) == within(1e-3, 0.4));
  CHECK(capillary_tension({0.0637, 1.0471975511966, 1000, 1e-3}) == within(1e-3, 0.2));
}
