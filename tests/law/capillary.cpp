// SPDX-License-Identifier: BSD-3-Clause
// The explicit capillary laws at two worked pairs: glass beads of 0.5 mm (and of 0.5 and 1 mm) radius with a bridge of
// a hundredth of the mean radius cubed of water, theta = 0. The numbers were worked out once from the published
// equations, by hand and apart from this library, to six digits.
#include "../catch.hpp"
#include "two_bodies.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/capillary/richefeu_harmonic.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/prepared.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/law/stiffness.hpp>

#include <boost/hana/for_each.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <pendular/law/all.hpp>

using namespace pendular;

namespace {
constexpr fluid water = fluid::water();
constexpr capillary::richefeu geometric{};
constexpr capillary::richefeu_harmonic harmonic{};

constexpr bridge<double> equal(double gap) { return {gap, 1.25e-12, 5e-4, 5e-4}; }
constexpr bridge<double> unequal(double gap) { return {gap, 3.53553390593e-12, 5e-4, 1e-3}; }

constexpr double six_digits = 5e-6;

constexpr double bead_mass = 1.361356816555577e-6;  // kg, 2600 kg/m3
constexpr two_bodies::pair beads{bead_mass, bead_mass, 5e-4, 5e-4};

/// Spring and capillary pull of the equal pair up to rupture.
double push(const approach<double>& a) {
  const double rupture_distance = rupture::lian{}.distance(equal(a.gap), water);
  const double attraction = a.gap <= rupture_distance ? geometric.attraction(equal(a.gap), water) : 0.0;
  return normal::linear{1e3}.repulsion(a) - attraction;
}

/// Largest gap of the equal pair that leaves `gap` with an opening speed.
double largest_gap(double gap, double opening_speed) {
  two_bodies::state s{gap, -opening_speed / 2, opening_speed / 2};
  double largest = gap;
  for (int k = 0; k < 400000 && largest < 130e-6 && s.closing_speed() <= 0; ++k) {
    s = two_bodies::step(beads, push, s, 2e-8);
    largest = std::max(largest, s.gap);
  }
  return largest;
}
}  // namespace

TEST_CASE("two equal beads pull with the force of the worked pair") {
  CHECK(capillary_tension(water) == within(six_digits, 0.457416));
  const double f0 = geometric.attraction(equal(0), water);
  CHECK(f0 == within(six_digits, 2.28708e-4));
  CHECK(geometric.attraction(equal(-1e-6), water) == f0);
  CHECK(geometric.attraction(equal(-1e-3), water) == f0);
  const double rupture_distance = rupture::lian{}.distance(equal(0), water);
  CHECK(rupture_distance == within(six_digits, 107.722e-6));
  CHECK(geometric.attraction(equal(rupture_distance), water) / f0 == within(six_digits, .0912807));
  CHECK(geometric.attraction(equal(45.000e-6), water) / f0 == within(six_digits, .367879));  // 1/e
  CHECK(geometric.energy(equal(0), water, rupture_distance) == within(six_digits, 9.35241e-9));
}

TEST_CASE("two unequal beads pull with the force of the worked pair") {
  const double f0 = geometric.attraction(unequal(0), water);
  CHECK(f0 == within(six_digits, 3.23442e-4));
  CHECK(geometric.attraction(unequal(46.3448e-6), water) / f0 == within(six_digits, .367879));
  const double rupture_distance = rupture::lian{}.distance(unequal(0), water);
  CHECK(rupture_distance == within(six_digits, 152.342e-6));
  CHECK(geometric.energy(unequal(0), water, rupture_distance) == within(six_digits, 1.44298e-8));
}

TEST_CASE("the harmonic mean differs from the geometric in its amplitude only") {
  // sqrt(0.5 * 1) mm against 2/3 mm: a ratio of sqrt(8)/3
  for (const double gap : {-1e-6, 0.0, 1e-6, 5e-5, 2e-4}) {
    const double ratio = harmonic.attraction(unequal(gap), water) / geometric.attraction(unequal(gap), water);
    CHECK(ratio == within(1e-12, 0.94280904158206));
    CHECK(harmonic.attraction(equal(gap), water) == within(1e-14, geometric.attraction(equal(gap), water)));
  }
}

TEST_CASE("a contact angle lowers the force by its cosine and leaves the decay length") {
  fluid tilted = water;
  for (const auto& [angle, cosine] : {std::pair{1.0471975511966, 0.5}, std::pair{0.7853981633974, 0.7071067811865}}) {
    tilted.contact_angle = angle;
    for (const double gap : {-1e-6, 0.0, 3e-5}) {
      const double dry = geometric.attraction(equal(gap), water);
      CHECK(geometric.attraction(equal(gap), tilted) == within(1e-11, cosine * dry));
    }
  }
  tilted.contact_angle = 1.5707963;
  CHECK(geometric.attraction(equal(0), tilted) >= 0);
  CHECK(geometric.attraction(equal(0), tilted) < 1e-7 * geometric.attraction(equal(0), water));
}

namespace {
template <class Check>
void for_each_with_energy(const Check& check) {
  boost::hana::for_each(law::capillary_laws, [&]<class L>(L) {
    if constexpr (HasCapillaryEnergy<typename L::type>) check(typename L::type{});
  });
}
}  // namespace

TEST_CASE("the energy is the area under the force", "[virtual_work]") {
  using integrator = boost::math::quadrature::gauss_kronrod<double, 61>;
  for_each_with_energy([](const auto& law) {
    for (const auto& of : {equal, unequal}) {
      const double rupture_distance = rupture::lian{}.distance(of(0), water);
      const auto force = [&](double gap) { return law.attraction(of(gap), water); };
      for (const double gap : {0.0, 1e-6, 4e-5, 1e-4}) {
        const double work = integrator::integrate(force, gap, rupture_distance, 10, 1e-12);
        CHECK(law.energy(of(gap), water, rupture_distance) == within(1e-10, work));
      }
      const double held = law.energy(of(-2e-6), water, rupture_distance) - law.energy(of(0), water, rupture_distance);
      CHECK(held == within(1e-9, 2e-6 * force(0)));
      CHECK(law.energy(of(rupture_distance), water, rupture_distance) == 0);
      CHECK(law.energy(of(2 * rupture_distance), water, rupture_distance) == 0);
    }
  });
}

TEST_CASE("the slope of the energy is the force", "[virtual_work]") {
  for_each_with_energy([](const auto& law) {
    for (const double gap : {-3e-6, 1e-7, 2e-5, 1e-4}) {
      const bridge<dual> b{detail::variable(gap), detail::constant(1.25e-12), detail::constant(5e-4),
                           detail::constant(5e-4)};
      const dual energy = law.energy(b, water, detail::constant(107.722e-6));
      CHECK(-energy.derivatives()(0) == within(1e-13, law.attraction(equal(gap), water)));
    }
  });
}

TEST_CASE("the slope of the force is minus the force over the decay length") {
  CHECK(slope(geometric, equal(1e-5), water) == within(six_digits, -geometric.attraction(equal(1e-5), water) / 45e-6));
  CHECK(slope(geometric, equal(-1e-6), water) == 0);
}

TEST_CASE("a wet contact at rest overlaps by the force over the stiffness and rings with its period") {
  CHECK(push({-.228708e-6, 0, 0, 5e-4, 5e-4}) == near(1e-9, 0.0));
  // A swing of a tenth of the static overlap, so that the contact never opens.
  two_bodies::state s{-.2058372e-6, 0, 0};
  double time = 0;
  const double dt = 163.93e-6 / 5000;
  while (s.closing_speed() >= 0) s = two_bodies::step(beads, push, s, dt), time += dt;
  CHECK(2 * time == within(5e-4, 163.93e-6));
}

TEST_CASE("the pair separates at its escape speed and not below") {
  CHECK(largest_gap(0, .165770 * 1.0002) > 110e-6);
  CHECK(largest_gap(0, .165770 * 0.9998) < 107.722e-6);
  CHECK(largest_gap(-.228708e-6, .166002 * 1.0002) > 110e-6);
  CHECK(largest_gap(-.228708e-6, .166002 * 0.9998) < 107.722e-6);
}

TEST_CASE("a bridge of vanishing volume acts in contact only") {
  for (const double volume : {0.0, 1e-300, 1e-40}) {
    const bridge<double> touching{0, volume, 5e-4, 5e-4};
    const bridge<double> open{1e-9, volume, 5e-4, 5e-4};
    CHECK(geometric.attraction(touching, water) == within(six_digits, 2.28708e-4));
    CHECK(geometric.attraction(open, water) < 1e-100);
    CHECK(geometric.energy(touching, water, 0.0) == 0);
    CHECK(geometric.energy(bridge<double>{-1e-6, volume, 5e-4, 5e-4}, water, 0.0) == within(six_digits, 2.28708e-10));
  }
  const bridge<float> dry{0.f, 0.f, 5e-4f, 5e-4f};
  CHECK(double(geometric.attraction(dry, water)) == within(1e-5, 2.28708e-4));
  CHECK(geometric.attraction(bridge<float>{1e-9f, 0.f, 5e-4f, 5e-4f}, water) == 0.f);
}

TEST_CASE("the capillary force reaches extreme size ratios and small sizes") {
  // at r = 100 the harmonic mean is 200/101 of the small radius, the geometric mean ten times it
  const bridge<double> wide{0, 1e-14, 5e-4, 5e-2};
  CHECK(harmonic.attraction(wide, water) == within(six_digits, 2.28708e-4 * 1.980198));
  CHECK(geometric.attraction(wide, water) == within(six_digits, 2.28708e-3));
  // micrometre grains with an attolitre, in float
  const bridge<float> small{1e-8f, 1e-20f, 1e-6f, 2e-6f};
  const double expected = geometric.attraction(bridge<double>{1e-8, 1e-20, 1e-6, 2e-6}, water);
  CHECK(double(geometric.attraction(small, water)) == within(1e-5, expected));
}

TEST_CASE("cached coefficients give the force of the simple form") {
  const auto c = prepare(geometric, unequal(0), water);
  CHECK(attraction(geometric, 2e-5, c, water) == within(1e-15, geometric.attraction(unequal(2e-5), water)));
  CHECK(c.amplitude == within(six_digits, 3.23442e-4));
  CHECK(1 / c.decay_rate == within(six_digits, 46.3448e-6));
}

TEST_CASE("another decay constant stretches the bridge in proportion") {
  const capillary::richefeu longer{1.8};
  CHECK(longer.attraction(equal(90e-6), water) == within(six_digits, 2.28708e-4 * .367879));
  CHECK_NOTHROW(validate(longer));
  CHECK_THROWS_AS(validate(capillary::richefeu{0}), input_error);
  CHECK_THROWS_AS(validate(capillary::richefeu_harmonic{-1}), input_error);
}

// Behind a wall the radius of j is infinite (law/inputs.hpp) and the harmonic mean is twice the radius of i. The law
// answers NaN as long as it multiplies before it divides.
TEST_CASE("the harmonic law pulls a grain to a wall with twice its radius") {
  const bridge<double> wall{0, 1e-13, 5e-4, std::numeric_limits<double>::infinity()};
  CHECK(harmonic.attraction(wall, water) == within(six_digits, 2 * 2.28708e-4));
}
