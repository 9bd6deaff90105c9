// SPDX-License-Identifier: BSD-3-Clause
// The composed laws at one contact, and the memory that follows it, in numbers worked out by hand.
#include "../catch.hpp"

#include <pendular/contact/force.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/law/normal/linear.hpp>

#include <cmath>
#include <numbers>

using namespace pendular;

namespace {
/// Overlap of 0.1 at a reduced mass of 1, approaching at the given speed and slipping along x at the given one.
encounter<double> meeting_at(double closing_speed, double slip) {
  encounter<double> e{};
  e.approaching = {-0.1, closing_speed, 1, 1, 1};
  e.normal = {0, 0, 1};
  e.velocity = {slip, 0, closing_speed};
  e.tangential_mass = 2.0 / 7;
  e.contacts = 1;
  return e;
}
const normal::linear spring{100};      // 10 N at an overlap of 0.1
const damping::viscous dashpot{0.25};  // 2 alpha sqrt(m k) = 5 N s/m
const friction::viscous_coulomb_explicit rough{1000, 0.5};

/// Tells by its traction what normal force it was given.
struct telling_friction {
  template <Scalar T>
  Vec3<T> traction(const slip<T>&, const T& normal_force) const {
    return {normal_force, T(0), T(0)};
  }
};
}  // namespace

TEST_CASE("push is elastic plus damping, and the damping is told apart") {
  none nothing;
  const auto f = touch(material{dashpot, spring}, meeting_at(0.4, 0), nothing, 1e-3);
  CHECK(f.push == within(1e-14, 12));
  CHECK(f.damping == within(1e-14, 2));
  CHECK(f.traction == vector{0, 0, 0});
  const auto undamped = touch(material{spring}, meeting_at(0.4, 0), nothing, 1e-3);
  CHECK((undamped.push == 10 && undamped.damping == 0));
}

TEST_CASE("the Coulomb limit takes elastic plus damping, floored at zero") {
  none nothing;
  const material m{spring, dashpot, rough};
  CHECK(touch(m, meeting_at(0.4, 1), nothing, 1e-3).traction.x == within(1e-14, -6));
  CHECK(touch(m, meeting_at(-0.4, 1), nothing, 1e-3).traction.x == within(1e-14, -4));
  // at -3 m/s the dashpot pulls with 15 N: a push of -5 N, which is kept, and no friction
  const auto f = touch(m, meeting_at(-3, 1), nothing, 1e-3);
  CHECK(f.push == within(1e-14, -5));
  CHECK(f.traction == vector{0, 0, 0});
}

TEST_CASE("a friction law is never given a negative normal force") {
  none nothing;
  const material m{spring, dashpot, telling_friction{}};
  CHECK(touch(m, meeting_at(0.4, 1), nothing, 1e-3).traction.x == within(1e-14, 12));
  CHECK(touch(m, meeting_at(-3, 1), nothing, 1e-3).traction.x == 0);
}

TEST_CASE("slip is the tangential velocity plus rolling") {
  none nothing;
  encounter<double> e = meeting_at(0.4, 1);
  e.rolling = {-1, 2, 0};
  const auto f = touch(material{spring, rough}, e, nothing, 1e-3);
  CHECK(f.slip_rate == vector{0, 2, 0});
  CHECK(f.traction.y == within(1e-14, -5));
}

TEST_CASE("a tangential memory turns with its contact and keeps its length") {
  vector memory{3, 0, 4};
  follow(memory, vector{0, 0, 1}, 0.0);  // the contact has tilted: what stuck out is laid down
  CHECK(memory.x == within(1e-14, 5));
  CHECK(memory.z == near(1e-14, 0));
  // a spin of the pair about its normal of 0.01 rad per step: after 157.08 steps a quarter turn
  vector turned{5, 0, 0};
  for (int k = 0; k < 157; ++k) follow(turned, vector{0, 0, 1}, std::numbers::pi / 314);
  CHECK(turned.y == near(1e-3, 5));
  CHECK(norm(turned) == within(1e-12, 5));
  vector empty{0, 0, 0};
  follow(empty, vector{0, 0, 1}, 0.1);
  CHECK(empty == vector{0, 0, 0});
}

TEST_CASE("a memory along the normal does not come back as something else") {
  vector along{0, 0, 2};
  follow(along, vector{0, 0, 1}, 0.0);
  CHECK(std::isfinite(along.x));
  CHECK(along == vector{0, 0, 0});
}

TEST_CASE("the spring of a contact is laid down before it is stretched on") {
  const friction::coulomb_spring law{1000, 10};
  friction::coulomb_spring::contact_memory<double> memory{{0, 0, 4}};
  memory.elastic_force = {0, 3, 4};
  const auto f = touch(material{spring, law}, meeting_at(0, 1), memory, 1e-3);
  CHECK(f.traction.x == within(1e-14, -1));
  CHECK(f.traction.y == within(1e-14, 5));
  CHECK(memory.elastic_force == f.traction);
}

TEST_CASE("a material hands out its own policies and validates them") {
  const material m{dashpot, rough, spring, energy_book{}};
  CHECK((m.normal().normal_stiffness == 100 && m.damping().damping_rate == 0.25 &&
         m.friction().friction_coefficient == 0.5));
  CHECK_THROWS_AS((material{normal::linear{-1}}), input_error);
  CHECK_THROWS_AS((material{spring, damping::viscous{-0.1}}), input_error);
  CHECK_THROWS_AS((material{friction::coulomb_spring{1, -1}, spring}), input_error);
}
