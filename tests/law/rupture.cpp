// SPDX-License-Identifier: BSD-3-Clause
// Rupture laws at round numbers; their distance from Laplace-Young is tested in laplace_young.cpp.
#include "../catch.hpp"

#include <pendular/law/rupture/lian.hpp>
#include <pendular/law/rupture/willett.hpp>

using namespace pendular;

namespace {
fluid wetting(double angle) { return {0.0728, angle, 998.2, 1.002e-3}; }
}  // namespace

TEST_CASE("Lian's bridge of a cubic millimetre breaks at a millimetre") {
  const bridge<double> b{0, 1e-9, 5e-4, 1e-3};
  CHECK(rupture::lian{}.distance(b, wetting(0)) == within(1e-14, 1e-3));
  CHECK(rupture::lian{}.distance(b, wetting(0.5)) == within(1e-14, 1.25e-3));
  CHECK(rupture::lian{}.distance(b, wetting(1.5707963)) == within(1e-7, 1.785398e-3));
  CHECK(rupture::lian{}.distance(bridge<double>{0, 0, 5e-4, 5e-4}, wetting(0)) == 0);
}

TEST_CASE("Willett's bridge at unit harmonic radius breaks at a sum of fractions") {
  // v = 1e-3: v^{1/3} = 0.1 and v^{2/3} = 0.01
  const bridge<double> equal{0, 1e-3, 1, 1};
  CHECK(rupture::willett{}.distance(equal, wetting(0)) == within(1e-14, 0.101));
  CHECK(rupture::willett{}.distance(equal, wetting(0.4)) == within(1e-14, 0.1212));
  // R_h = 1, rho = 1/3: 0.1 + (1/6 - 2/5) 0.01, and 1 + theta/3
  const bridge<double> unequal{0, 1e-3, 2.0 / 3, 2};
  CHECK(rupture::willett{}.distance(unequal, wetting(0)) == within(1e-13, 0.0976666666666667));
  CHECK(rupture::willett{}.distance(unequal, wetting(0.3)) == within(1e-13, 0.1074333333333333));
  CHECK(rupture::willett{}.distance(bridge<double>{0, 0, 1, 2}, wetting(0.3)) == 0);
}

TEST_CASE("rupture distances in float keep their digits for an attolitre") {
  const float lian = rupture::lian{}.distance(bridge<float>{0.f, 1e-21f, 1e-6f, 1e-4f}, wetting(0));
  CHECK(double(lian) == within(1e-6, 1e-7));
  const double expected = rupture::willett{}.distance(bridge<double>{0, 1e-21, 1e-6, 1e-4}, wetting(0));
  const float willett = rupture::willett{}.distance(bridge<float>{0.f, 1e-21f, 1e-6f, 1e-4f}, wetting(0));
  CHECK(double(willett) == within(1e-6, expected));
}
