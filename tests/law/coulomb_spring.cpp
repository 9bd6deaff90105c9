// SPDX-License-Identifier: BSD-3-Clause
// The tangential spring by hand: 800 N/m, mu = 0.4, 1 mN of normal force, hence 0.4 mN of friction, reached after a slip
// of 0.5 um. At 1 mm/s and steps of 1 us the slip is 1 nm and the force 0.8 uN per step.
#include "../catch.hpp"

#include <pendular/law/friction/coulomb_spring.hpp>

#include <cmath>

using namespace pendular;

namespace {
constexpr friction::coulomb_spring law{800.0, 0.4};
using memory_of_spring = friction::coulomb_spring::contact_memory<double>;
constexpr double normal_force = 1e-3;

struct contact {
  memory_of_spring memory{};
  double work = 0;  // of the traction, J
  Vec3<double> force{};

  /// Slip at 1 mm/s in the plane for a number of steps.
  void drag(double x, double y, int steps) {
    const slip<double> s{{1e-3 * x, 1e-3 * y, 0}, {0, 0, 1}, 2e-7, 1, 1e-6};
    for (int k = 0; k < steps; ++k) {
      const Vec3<double> before = force;
      force = law.traction(s, normal_force, memory);
      work += 0.5e-6 * dot(before + force, s.velocity);
    }
  }
};
}  // namespace

TEST_CASE("the spring pulls back in proportion to the slip") {
  contact c;
  c.drag(1, 0, 100);
  CHECK(c.force.x == within(1e-12, -8e-5));
  CHECK(c.force.y == 0);
  CHECK(law.energy(c.memory) == within(1e-12, 4e-12));
  CHECK(-c.work == within(1e-12, 4e-12));
}

TEST_CASE("a contact at rest keeps its force") {
  contact c;
  c.drag(1, 0, 100);
  c.drag(0, 0, 1000);
  CHECK(c.force.x == within(1e-12, -8e-5));
}

TEST_CASE("the spring slides at the Coulomb force and stores no more than it held") {
  contact c;
  c.drag(1, 0, 500);
  CHECK(c.force.x == within(1e-12, -4e-4));
  c.drag(1, 0, 100);
  CHECK(c.force.x == within(1e-12, -4e-4));
  CHECK(law.energy(c.memory) == within(1e-12, 1e-10));
  CHECK(-c.work - law.energy(c.memory) == within(1e-9, 4e-11));  // 0.1 um at 0.4 mN
}

TEST_CASE("loading, unloading and reloading run through the hysteresis loop") {
  contact c;
  c.drag(1, 0, 600);
  c.drag(-1, 0, 250);
  CHECK(c.force.x == within(1e-11, -2e-4));
  c.drag(-1, 0, 250);
  CHECK(c.force.x == near(1e-15, 0.0));
  c.drag(-1, 0, 600);
  CHECK(c.force.x == within(1e-12, 4e-4));
  const double before = c.work;
  c.drag(1, 0, 1100);
  CHECK(c.force.x == within(1e-12, -4e-4));
  c.drag(-1, 0, 1100);
  CHECK(c.force.x == within(1e-12, 4e-4));
  // A parallelogram: 2 * 0.4 mN high, 0.1 um wide.
  CHECK(before - c.work == within(1e-9, 8e-11));
}

TEST_CASE("a capped spring turns towards the new direction of slip") {
  contact c;
  c.drag(1, 0, 600);
  for (int k = 0; k < 4000; ++k) {
    c.drag(0, 1, 1);
    REQUIRE(norm(c.force) <= 4e-4 * (1 + 1e-14));
  }
  CHECK(c.force.y == within(1e-4, -4e-4));
  CHECK(std::abs(c.force.x) < 4e-6);
}

TEST_CASE("a loss of normal force releases the spring for good") {
  contact c;
  c.drag(1, 0, 400);
  const slip<double> still{{0, 0, 0}, {0, 0, 1}, 2e-7, 1, 1e-6};
  CHECK(law.traction(still, 5e-4, c.memory).x == within(1e-12, -2e-4));
  CHECK(law.traction(still, 1e-3, c.memory).x == within(1e-12, -2e-4));
  CHECK(law.traction(still, 0.0, c.memory) == Vec3<double>{0, 0, 0});
  CHECK(law.traction(still, 1e-3, c.memory) == Vec3<double>{0, 0, 0});
  CHECK(law.energy(c.memory) == 0);
}

TEST_CASE("the spring in float follows the spring in double") {
  friction::coulomb_spring::contact_memory<float> memory{{0, 0, 0}};
  const slip<float> s{{1e-3f, 0.f, 0.f}, {0.f, 0.f, 1.f}, 2e-7f, 1.f, 1e-6};
  Vec3<float> force{};
  for (int k = 0; k < 100; ++k) force = law.traction(s, 1e-3f, memory);
  CHECK(double(force.x) == within(1e-5, -8e-5));
  for (int k = 0; k < 900; ++k) force = law.traction(s, 1e-3f, memory);
  CHECK(double(force.x) == within(1e-6, -4e-4));
}

TEST_CASE("spring parameters without meaning are refused") {
  CHECK_NOTHROW(validate(law));
  CHECK_THROWS_AS(validate(friction::coulomb_spring{0, 0.4}), input_error);
  CHECK_THROWS_AS(validate(friction::coulomb_spring{800, -0.1}), input_error);
  CHECK_THROWS_AS(validate(friction::coulomb_spring{std::nan(""), 0.1}), input_error);
}
