// SPDX-License-Identifier: BSD-3-Clause
// The law from the table against the solver it is made from, at bridges that are no nodes of the table.
#include "../catch.hpp"
#include "samples.hpp"

#include <pendular/laplace_young/law.hpp>
#include <pendular/law/check.hpp>
#include <pendular/law/stiffness.hpp>
#include <pendular/liquid/liquid.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/testing/law_kits.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>

using namespace pendular;
using samples::radius;

static_assert(check::capillary_law<capillary::laplace_young> && check::rupture_law<rupture::laplace_young>);
static_assert(HasCapillaryEnergy<capillary::laplace_young>);

namespace {
constexpr double degree = std::numbers::pi / 180;

fluid water(double degrees) { return {0.072, degrees * degree, 1000, 1e-3}; }

struct worst {
  double force = 0, rupture = 0;
};

/// Over gaps at equal s = sqrt(1 - D/D_r), in units of 2 pi gamma R_h.
void compare(const bridge<double>& b, const fluid& f, worst& so_far) {
  const capillary::laplace_young law(f);
  const rupture::laplace_young rupture_law(f);
  laplace_young::bridges_of_volume exact({b.radius_i, b.radius_j, f.contact_angle, b.volume, f.surface_tension});
  const double farthest = exact.rupture_distance(), own = rupture_law.distance(b, f);
  const double unit = 2 * std::numbers::pi * f.surface_tension * capillary::harmonic_radius(b);
  so_far.rupture = std::max(so_far.rupture, std::abs(own / farthest - 1));
  for (int k = 0; k <= 30; ++k) {
    const double left = 1 - k * k / 900.0;
    const double force = law.attraction(bridge<double>{left * own, b.volume, b.radius_i, b.radius_j}, f);
    so_far.force = std::max(so_far.force, std::abs(force - exact.at(left * farthest)->attraction) / unit);
  }
}

/// Bridges of [1e-6, 0.3] R^3 and ratios to 10, of which a part nearly equal.
template <class Use>
void for_bridges(int count, unsigned seed, const Use& use) {
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < count; ++k) {
    const double ratio = k % 5 == 0   ? 1
                         : k % 5 == 1 ? 1 + std::pow(10, -1.3 - 5 * unit(random))
                                      : std::pow(10, unit(random));
    const double v = 1e-6 * std::pow(0.3e6, unit(random));
    use(bridge<double>{0, v * std::pow(ratio, 1.5) * radius * radius * radius, radius, ratio * radius}, ratio);
  }
}
}  // namespace

TEST_CASE("the table is Laplace-Young to 1e-4 in the force and 1e-6 in the rupture distance", "[slow]") {
  for (const double angle : {0.0, 12.0, 22.0, 37.0, 45.0, 60.0}) {
    worst found;
    for_bridges(60, 11, [&](const bridge<double>& b, double) { compare(b, water(angle), found); });
    CAPTURE(angle, found.force, found.rupture);
    CHECK(found.force < 1e-4);
    CHECK(found.rupture < 1e-6);
  }
}

TEST_CASE("so it is between a grain and a wall", "[slow]") {
  for (const double angle : {0.0, 12.0, 28.0, 31.0, 45.0, 60.0}) {
    worst found;
    for (int k = 0; k <= 60; ++k) {
      const double v = 1e-6 * std::pow(0.3e6, k / 60.0);
      compare({0, v * radius * radius * radius, radius, wall_radius(radius)}, water(angle), found);
    }
    CAPTURE(angle, found.force, found.rupture);
    CHECK(found.force < 1e-4);
    CHECK(found.rupture < 1e-6);
  }
}

TEST_CASE("where equal spheres begin to break by the antisymmetric mode it is so to 5e-4 and 2e-5", "[slow]") {
  for (const double angle : {26.0, 28.0, 31.0, 34.0}) {
    worst equal, others;
    for_bridges(60, 12, [&](const bridge<double>& b, double ratio) {
      compare(b, water(angle), ratio < 1.06 ? equal : others);
    });
    CAPTURE(angle, equal.force, equal.rupture, others.force, others.rupture);
    CHECK(equal.force < 5e-4);
    CHECK(equal.rupture < 2e-5);
    CHECK(others.force < 1e-4);
    CHECK(others.rupture < 1e-6);
  }
}

TEST_CASE("the table laws keep the promises of their concepts, in every scalar") {
  for (const double angle : {0.0, 30.0}) {
    for (const std::string& broken :
         testing::capillary_law_report(capillary::laplace_young(water(angle)), water(angle))) {
      FAIL_CHECK(broken);
    }
    for (const std::string& broken : testing::rupture_law_report(rupture::laplace_young(water(angle)), water(angle))) {
      FAIL_CHECK(broken);
    }
  }
}

TEST_CASE("the table law in fifty digits is the one in double") {
  using exact = boost::multiprecision::cpp_bin_float_50;
  const fluid f = water(20);
  const capillary::laplace_young law(f);
  const bridge<double> b{2e-5, 1e-12, radius, 3 * radius};
  const bridge<exact> wide{exact(b.gap), exact(b.volume), exact(b.radius_i), exact(b.radius_j)};
  CHECK(static_cast<double>(exact(law.attraction(wide, f))) == within(1e-12, law.attraction(b, f)));
}

TEST_CASE("the energy of the table law is that of the solver") {
  const fluid f = water(15);
  const capillary::laplace_young law(f);
  laplace_young::bridges_of_volume exact({radius, 2 * radius, f.contact_angle, 1e-11, f.surface_tension});
  const double farthest = exact.rupture_distance(), unit = f.surface_tension * radius * farthest;
  for (const double part : {0.0, 0.2, 0.6, 0.95}) {
    const bridge<double> b{part * farthest, 1e-11, radius, 2 * radius};
    const double work = exact.last().energy - exact.at(part * farthest)->energy;
    CHECK(law.energy(b, f, farthest) == near(3e-4 * unit, work));
  }
}

TEST_CASE("beyond its ratios and volumes the table law stays near the solver and finite") {
  const fluid f = water(0);
  const capillary::laplace_young law(f);
  for (const auto& [ratio, volume] : {std::array{50.0, 1e-3}, std::array{1.0, 1e-9}, std::array{1.0, 0.5}}) {
    const double v = volume * radius * radius * radius;
    const auto exact = laplace_young::solve({radius, ratio * radius, 0, v, f.surface_tension}, 0);
    CHECK(law.attraction(bridge<double>{0, v, radius, ratio * radius}, f) == within(0.08, exact->attraction));
  }
  CHECK(law.attraction(bridge<double>{1e-3, 0, radius, radius}, f) == near(1e-12, 0));
  CHECK(std::isfinite(law.attraction(bridge<float>{0, 0, 1e-3f, 1e-3f}, f)));
  const double plane = law.attraction(bridge<double>{1e-5, 1e-12, radius, samples::infinite}, f);
  CHECK(plane ==
        within(0.1, laplace_young::solve({radius, samples::infinite, 0, 1e-12, f.surface_tension}, 1e-5)->attraction));
  CHECK_THROWS_AS(capillary::laplace_young(water(88)), input_error);
  CHECK(capillary::laplace_young::valid.covers({0, 0.29 * std::pow(10, 1.5), 1, 10}, f));
  CHECK_FALSE(capillary::laplace_young::valid.covers({0, 0.9e-6, 1, 1}, f));
}

TEST_CASE("a closed contact is pushed at large angles and volumes, by the table as by the solver") {
  const fluid f = water(79);
  const capillary::laplace_young law(f);
  const double unit = 2 * std::numbers::pi * f.surface_tension * radius;
  for (const auto& [v, pull] : {std::pair{1e-2, 0.0496}, {1e-1, -0.0602}}) {
    const bridge<double> b{0, v * radius * radius * radius, radius, radius};
    const auto exact = laplace_young::solve({b.radius_i, b.radius_j, f.contact_angle, b.volume, f.surface_tension}, 0);
    CHECK(exact->attraction == near(1e-4 * unit, pull * unit));
    CHECK(law.attraction(b, f) == near(1e-4 * unit, exact->attraction));
  }
}

TEST_CASE("the slope of the force is a number, for equal spheres and at rupture too") {
  const fluid f = water(0);
  const capillary::laplace_young law(f);
  const auto force = [&](double gap) { return law.attraction(bridge<double>{gap, 1e-12, radius, radius}, f); };
  const double h = 1e-9, gap = 2e-5;
  CHECK(slope(law, bridge<double>{gap, 1e-12, radius, radius}, f) ==
        within(1e-5, (force(gap + h) - force(gap - h)) / (2 * h)));
  CHECK(std::isfinite(slope(law, bridge<double>{1e-3, 1e-12, radius, radius}, f)));
}

TEST_CASE("a table for another contact angle than the liquid's is refused") {
  const capillary::laplace_young law(water(20));
  const rupture::laplace_young rupture_law(water(20));
  CHECK_NOTHROW(liquid{water(20), law, rupture_law});
  CHECK_THROWS_AS((liquid{water(21), law, rupture_law}), input_error);
  CHECK_THROWS_AS((liquid{water(0), capillary::laplace_young(water(0)), rupture_law}), input_error);
}
