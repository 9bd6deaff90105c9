// SPDX-License-Identifier: BSD-3-Clause
// Damping laws by the restitution they lead to. The expected values are those of the closed forms of the damped
// oscillator (Schwager and Poeschel, Granular Matter 9, 465 (2007), and its variants), evaluated once to five digits.
#include "../catch.hpp"
#include "two_bodies.hpp"

#include <pendular/core/lanes.hpp>
#include <pendular/law/damping/clamped.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/damping/viscous_on_approach.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/stiffness.hpp>

#include <limits>

using namespace pendular;

namespace {
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct row {
  double damping_rate, on_approach, two_sided, clamped;
};
constexpr row restitutions[] = {
    {.05, .92669, .85447, .85876}, {.1, .86260, .72925, .74408}, {.2, .75613, .52662, .57174},
    {.3, .67155, .37233, .45098},  {.5, .54629, .16303, .29844}, {.8, .42401, .01516, .17978},
    {.9, .39406, .00152, .15528},
};

// Unequal on purpose: the reduced mass is not half of either.
constexpr two_bodies::pair grains{1e-6, 3e-6, 5e-4, 7e-4};
constexpr double half_period = 86.0364e-6;  // s, at 1e3 N/m

template <class Spring, class Damping>
auto sum(const Spring& spring, const Damping& dashpot) {
  return [=](const approach<double>& a) {
    const double push = spring.repulsion(a);
    return push + resistance(dashpot, a, elastic<double>{push, stiffness(spring, a)});
  };
}

approach<double> contact(double gap, double closing_speed) { return {gap, closing_speed, 4e-6, 5e-4, 5e-4}; }
}  // namespace

TEST_CASE("restitution follows from the damping rate") {
  const normal::linear spring{1e3};
  const double dt = half_period / 20000;
  for (const row& r : restitutions) {
    CAPTURE(r.damping_rate);
    const auto two_sided = sum(spring, damping::viscous{r.damping_rate});
    const auto on_approach = sum(spring, damping::viscous_on_approach{r.damping_rate});
    const auto clamped = sum(spring, damping::clamped{damping::viscous{r.damping_rate}});
    CHECK(two_bodies::collide(grains, two_sided, 0.3, -0.1, dt).restitution() == near(1e-5, r.two_sided));
    CHECK(two_bodies::collide(grains, on_approach, 0.3, -0.1, dt).restitution() == near(1e-5, r.on_approach));
    CHECK(two_bodies::collide(grains, clamped, 0.3, -0.1, dt).restitution() == near(2e-5, r.clamped));
  }
}

TEST_CASE("momentum is kept and the restitution does not know the speed") {
  const auto push = sum(normal::linear{1e3}, damping::viscous{0.2});
  for (const double speed : {1e-6, 1e-2, 10.0}) {
    const auto found = two_bodies::collide(grains, push, speed, 0, half_period / 5000);
    CHECK(found.restitution() == near(5e-5, .52662));
    CHECK(1e-6 * found.after.velocity_i + 3e-6 * found.after.velocity_j == within(1e-12, 1e-6 * speed));
  }
}

TEST_CASE("a contact damped on approach only swings back undamped") {
  // duration arccos(1/2) / (omega sqrt(3/4)) + pi / (2 omega), largest overlap (v / omega) e
  const auto push = sum(normal::linear{1e3}, damping::viscous_on_approach{0.5});
  const auto found = two_bodies::collide(grains, push, 0.1, 0, half_period / 20000);
  CHECK(found.duration == within(1e-6, 76.133323e-6));
  CHECK(found.deepest == within(1e-6, 1.496085e-6));
}

TEST_CASE("the dashpot opposes the closing speed in contact only") {
  // 2 * 0.5 * sqrt(4e-6 * 1e4) = 0.2 N s/m
  const damping::viscous two_sided{0.5};
  const damping::viscous_on_approach on_approach{0.5};
  CHECK(two_sided.resistance(contact(-1e-6, 3.0), 1e4) == within(1e-15, 0.6));
  CHECK(two_sided.resistance(contact(-1e-6, -3.0), 1e4) == within(1e-15, -0.6));
  CHECK(on_approach.resistance(contact(-1e-6, 3.0), 1e4) == within(1e-15, 0.6));
  CHECK(on_approach.resistance(contact(-1e-6, -3.0), 1e4) == 0);
  for (const double gap : {0.0, 1e-300, 1e-6}) {
    CHECK(two_sided.resistance(contact(gap, 3.0), 1e4) == 0);
    CHECK(two_sided.resistance(contact(gap, -3.0), 1e4) == 0);
    CHECK(on_approach.resistance(contact(gap, 3.0), 1e4) == 0);
  }
  CHECK(two_sided.resistance(contact(-1e-300, 3.0), 1e4) == within(1e-15, 0.6));
}

// The substitution q ~ overlap^{5/4}, d(sigma) ~ overlap^{1/4} dt of Antypov and Elliott (EPL 94, 50004, 2011) makes a
// Hertz contact under a dashpot of its tangent stiffness linear, with sqrt(6/5) of the rate: e of the closed form there, and
// the same six digits by a Runge-Kutta integration of y'' = -max(y^{3/2} + 2 alpha sqrt(3/2) y^{1/4} y', 0) in Python.
TEST_CASE("a clamped dashpot never makes a Hertz contact attractive and rebounds at any speed alike") {
  struct expected {
    double damping_rate, restitution;
  };
  for (const auto [rate, e] : {expected{.1, .724674}, {.3, .423113}, {.5, .273152}, {.8, .160619}}) {
    for (const double speed : {0.01, 1.0}) {
      for (const bool at_wall : {false, true}) {
        CAPTURE(rate, speed, at_wall);
        constexpr double far = std::numeric_limits<double>::infinity();
        const two_bodies::pair p = at_wall ? two_bodies::pair{1e-6, far, 5e-4, far} : grains;
        const normal::hertz spring{1e7, 0.25};
        double least = 0;
        const auto push = [&,
                           total = sum(spring, damping::clamped{damping::viscous{rate}})](const approach<double>& a) {
          const double force = total(a);
          least = std::min(least, force);
          return force;
        };
        // duration about 3 (m / (4/3 E* sqrt(R*)))^{2/5} v^{-1/5}
        const double scale = spring.contact_modulus() * std::sqrt(5e-4) / p.reduced_mass();
        const double dt = std::pow(scale, -0.4) * std::pow(speed, -0.2) / 5000;
        CHECK(two_bodies::collide(p, push, speed, 0, dt).restitution() == near(3e-5, e));
        CHECK(least == 0);
      }
    }
  }
}

TEST_CASE("a clamped dashpot is its dashpot until spring and dashpot together would pull") {
  // 2 * 0.5 * sqrt(4e-6 * 1e4) = 0.2 N s/m beside a spring of 0.01 N
  const damping::clamped law{damping::viscous{0.5}};
  const elastic<double> spring{0.01, 1e4};
  CHECK(law.resistance(contact(-1e-6, 3.0), spring) == within(1e-15, 0.6));
  CHECK(law.resistance(contact(-1e-6, -0.04), spring) == within(1e-15, -0.008));
  CHECK(law.resistance(contact(-1e-6, -0.06), spring) == -0.01);
  CHECK(law.resistance(contact(-1e-6, 0), spring) == 0);
  CHECK(law.resistance(contact(1e-6, -3.0), elastic<double>{0, 1e4}) == 0);
  const damping::clamped twice{law};
  static_assert(std::is_same_v<decltype(twice), const damping::clamped<damping::viscous>>);
}

TEST_CASE("damping reads the tangent stiffness of a Hertz contact") {
  // contact modulus 1e6 Pa, R* = 0.25 mm, overlap 1 um: 2e6 sqrt(2.5e-10) = 31.6227766 N/m
  const normal::hertz spring{1.5e6, 0.5};
  const double k = stiffness(spring, contact(-1e-6, 1.0));
  CHECK(k == within(1e-12, 31.6227766016838));
  CHECK(damping::viscous{0.25}.resistance(contact(-1e-6, 1.0), k) == within(1e-12, 0.00562341325190349));
}

TEST_CASE("damping in float and in lanes is damping in double") {
  const damping::viscous law{0.8};
  const float found = law.resistance(approach<float>{-1e-9f, 1e-4f, 1e-9f, 1e-4f, 1e-4f}, 1e3f);
  CHECK(double(found) == within(1e-6, law.resistance(approach<double>{-1e-9, 1e-4, 1e-9, 1e-4, 1e-4}, 1e3)));
  using sixteen = lanes<16, float>;
  const approach<sixteen> open{sixteen(1e-9), sixteen(1.), sixteen(1e-9), sixteen(1e-4), sixteen(1e-4)};
  CHECK(all(law.resistance(open, sixteen(1e3)) == 0));
}

TEST_CASE("damping rates outside the published range are refused") {
  CHECK_NOTHROW(validate(damping::viscous{0}));
  CHECK_NOTHROW(validate(damping::viscous_on_approach{0.8}));
  CHECK_THROWS_AS(validate(damping::viscous{-0.1}), input_error);
  CHECK_THROWS_AS(validate(damping::viscous{1.01}), input_error);
  CHECK_THROWS_AS(validate(damping::viscous{nothing}), input_error);
  CHECK_THROWS_AS(validate(damping::viscous_on_approach{-0.1}), input_error);
  CHECK_NOTHROW(validate(damping::clamped{damping::viscous{0.8}}));
  CHECK_THROWS_AS(validate(damping::clamped{damping::viscous{1.01}}), input_error);
  CHECK_THROWS_AS(validate(damping::viscous_on_approach{nothing}), input_error);
}

// The papers let alpha_n run to 1, the critical rate, where nothing is singular: only the closed forms of e need a limit.
TEST_CASE("the critical damping rate belongs to the published range") {
  CHECK_NOTHROW(validate(damping::viscous{1.0}));
  CHECK_NOTHROW(validate(damping::viscous_on_approach{1.0}));
}

TEST_CASE("at the critical rate a contact damped on approach rebounds with 1/e and a clamped one with its square") {
  const normal::linear spring{1e3};
  const auto on_approach = sum(spring, damping::viscous_on_approach{1.0});
  const auto clamped = sum(spring, damping::clamped{damping::viscous{1.0}});
  const double dt = half_period / 20000;
  CHECK(two_bodies::collide(grains, on_approach, 0.3, -0.1, dt).restitution() == near(1e-5, .367879));
  CHECK(two_bodies::collide(grains, clamped, 0.3, -0.1, dt).restitution() == near(2e-5, .135335));
}
