// SPDX-License-Identifier: BSD-3-Clause
// Viscous-regularised friction on a single block against the closed form of its linear equation of motion,
// m dv/dt = F - gamma v, hence v = F/gamma + (v0 - F/gamma) exp(-gamma t / m), and against Coulomb's cone.
#include "../catch.hpp"
#include "slider.hpp"

#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>

#include <Eigen/Core>
#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pendular;
using blocks::slider;

namespace {
constexpr auto both = boost::hana::tuple_t<friction::viscous_coulomb, friction::viscous_coulomb_explicit>;
constexpr double mass = 2e-7;  // tangential mass of a pair of beads of a millimetre, kg

template <class Law, class T>
Vec3<T> first_traction(const Law& law, const Vec3<T>& velocity, const T& normal_force, double time_step = 1e-12) {
  auto memory = testing::fresh_memory<contact_memory_t<Law, T>, T>();
  return testing::traction(law, slip<T>{velocity, {T(0), T(0), T(1)}, T(mass), T(1), time_step}, normal_force, memory);
}

/// Velocity after `duration` of a block that is pushed beyond sliding, let go, and pushed back.
template <class Law>
double velocity_after_a_push(const Law& law, double time_step) {
  slider b{law, mass, 1e-3, time_step};
  const double duration = 4e-5;
  const auto steps = std::lround(duration / time_step);
  for (long k = 0; k < steps; ++k) {
    const double t = double(k) * time_step;
    b.step(t < 1.9999e-5 ? 6e-4 : -2e-4);
  }
  return b.velocity;
}
}  // namespace

TEST_CASE("at zero slip there is no traction and no division by zero") {
  boost::hana::for_each(both, [](auto type) {
    const typename decltype(type)::type law{1.0, 0.4};
    const Vec3<double> none{0, 0, 0};
    for (const double normal_force : {0.0, 1e-300, 1e-3, 1e3}) CHECK(first_traction(law, none, normal_force) == none);
    const Vec3<double> drag = first_traction(law, Vec3<double>{1e-3, 0, 0}, 0.0);
    CHECK(drag == none);
    const Vec3<float> in_float = first_traction(law, Vec3<float>{0.f, 0.f, 0.f}, 0.f);
    CHECK(in_float == Vec3<float>{0, 0, 0});
    using eight = lanes<8>;
    const Vec3<eight> in_lanes = first_traction(law, {eight(0), eight(0), eight(0)}, eight(0));
    CHECK(all(in_lanes.x == 0));
  });
}

TEST_CASE("slow slip is resisted in proportion and fast slip by the Coulomb force") {
  boost::hana::for_each(both, [](auto type) {
    // gamma 2 N s/m, mu N = 0.3 * 1e-3 N: the threshold is at 0.15 mm/s
    const typename decltype(type)::type law{2.0, 0.3};
    const Vec3<double> slow = first_traction(law, Vec3<double>{-6e-5, 8e-5, 0}, 1e-3);
    CHECK(slow.x == within(1e-4, 1.2e-4));
    CHECK(slow.y == within(1e-4, -1.6e-4));
    const Vec3<double> fast = first_traction(law, Vec3<double>{-0.6, 0.8, 0}, 1e-3);
    CHECK(fast.x == within(1e-12, 1.8e-4));
    CHECK(fast.y == within(1e-12, -2.4e-4));
    CHECK(fast.z == 0);
  });
}

TEST_CASE("steady slip is the pull over the viscosity at every time step") {
  for (const double ratio : {1e-3, 1e-2, 0.1, 1.0, 3.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6}) {
    for (const double time_step : {1e-8, 1e-6, 1e-4}) {
      CAPTURE(ratio, time_step);
      const double viscosity = ratio * mass / time_step;
      const double normal_force = 1e-3;
      const double pull = 0.9 * 0.4 * normal_force;
      slider b{friction::viscous_coulomb{viscosity, 0.4}, mass, normal_force, time_step};
      // 40 relaxation times of the dashpot at small ratios, of the numerical element at large ones
      const int steps = int(40 / std::min(ratio, 0.1)) + 1000;
      double highest = 0;
      for (int k = 0; k < steps; ++k) {
        b.step(pull);
        highest = std::max(highest, std::abs(b.traction));
      }
      // The last term is rounding: the velocity is the difference of impulses `ratio` times larger.
      CHECK(b.velocity == within(1e-10 + 1.5e-15 * ratio, pull / viscosity));
      CHECK(highest <= 0.4 * normal_force * (1 + 1e-15));
    }
  }
}

TEST_CASE("steady slip does not depend on the number of contacts counted") {
  for (const double contacts : {1.0, 6.0, 12.0}) {
    const friction::viscous_coulomb law{0.1, 0.4};
    friction::viscous_coulomb::contact_memory<double> memory{};
    const slip<double> s{{1e-5, 0, 0}, {0, 0, 1}, mass, contacts, 1e-6};
    Vec3<double> force{};
    for (int k = 0; k < 20000; ++k) force = law.traction(s, 1.0, memory);
    CHECK(force.x == within(1e-12, -1e-6));
  }
}

TEST_CASE("a pull beyond the cone accelerates by what is left over") {
  boost::hana::for_each(both, [](auto type) {
    slider b{typename decltype(type)::type{1.0, 0.4}, mass, 1e-3, 1e-8};
    for (int k = 0; k < 20000; ++k) b.step(7e-4);
    // After 0.2 ms at (7e-4 - 4e-4) N over 2e-7 kg: 0.3 m/s, and the viscous start adds less than 2e-4 m/s of speed.
    CHECK(b.velocity == near(5e-4, 0.3));
    CHECK(b.traction == within(1e-12, -4e-4));
  });
}

TEST_CASE("the traction stays inside the cone whatever the contact went through") {
  const friction::viscous_coulomb law{5.0, 0.4};
  friction::viscous_coulomb::contact_memory<double> memory{};
  double worst = 0;
  std::uint64_t seed = 88172645463325252u;
  const auto random = [&] {  // in [-1, 1)
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return double(seed >> 11) * 0x1p-52 - 1;
  };
  for (int k = 0; k < 100000; ++k) {
    const double speed = std::pow(10.0, 6 * random() - 3);
    const double normal_force = k % 7 == 0 ? 0.0 : std::pow(10.0, 3 * random() - 3);
    const slip<double> s{{speed * random(), speed * random(), 0}, {0, 0, 1}, mass, 4, std::pow(10.0, 2 * random() - 6)};
    const Vec3<double> force = law.traction(s, normal_force, memory);
    worst = std::max(worst, norm(force) - 0.4 * normal_force * (1 + 1e-14));
    REQUIRE(std::isfinite(force.x + force.y + memory.elastic_force.x));
  }
  CHECK(worst <= 0);
}

TEST_CASE("viscous creep is approached at first order in the time step") {
  // gamma/m = 1e6 1/s; a pull towards 5e-4 m/s and a start at 3e-4 m/s: after 1 us v = (5 - 2/e) 1e-4 m/s
  const double exact = 4.2642411176571153e-4;
  boost::hana::for_each(both, [&](auto type) {
    double last = 0;
    for (const int steps : {1000, 2000, 4000, 8000}) {
      slider b{typename decltype(type)::type{0.2, 0.4}, mass, 1e-3, 1e-6 / steps, 3e-4};
      for (int k = 0; k < steps; ++k) b.step(1e-4);
      const double error = std::abs(b.velocity - exact);
      if (last > 0) CHECK(last / error == near(0.1, 2.0));
      last = error;
    }
    CHECK(last < 2e-3 * exact);
  });
}

TEST_CASE("through sliding and sticking both forms follow one trajectory as the time step vanishes") {
  const double reference = velocity_after_a_push(friction::viscous_coulomb_explicit{0.2, 0.4}, 1e-10);
  double last = 0;
  for (const double time_step : {1e-8, 5e-9, 2.5e-9}) {
    const double found = velocity_after_a_push(friction::viscous_coulomb{0.2, 0.4}, time_step);
    const double error = std::abs(found - reference);
    if (last > 0) CHECK(last / error == near(0.4, 2.0));
    last = error;
  }
  CHECK(last < 1e-2 * std::abs(reference));
}

TEST_CASE("beyond its stability limit the explicit form alternates and grows; the other does not") {
  const double time_step = 1e-6;
  for (const double ratio : {2.5, 5.0, 1e3}) {
    const double viscosity = ratio * mass / time_step;
    slider published{friction::viscous_coulomb_explicit{viscosity, 0.4}, mass, 1.0, time_step, 1e-9};
    slider stable{friction::viscous_coulomb{viscosity, 0.4}, mass, 1.0, time_step, 1e-9};
    double highest = 0;
    for (int k = 0; k < 8; ++k) {
      const double before = published.velocity;
      published.step(0);
      CHECK(published.velocity * before < 0);
      CHECK((std::abs(published.velocity) > std::abs(before) || 0.4 * time_step / mass < std::abs(2 * before)));
      stable.step(0);
      highest = std::max(highest, std::abs(stable.velocity));
    }
    for (int k = 0; k < 300; ++k) stable.step(0);
    CHECK(highest < 1e-9);
    CHECK(std::abs(stable.velocity) < 1e-2 * 1e-9);
  }
  slider calm{friction::viscous_coulomb_explicit{1.9 * mass / time_step, 0.4}, mass, 1.0, time_step, 1e-9};
  for (int k = 0; k < 300; ++k) calm.step(0);
  CHECK(std::abs(calm.velocity) < 1e-20);
}

TEST_CASE("a stiff contact comes to rest without ringing, even when its mass is overestimated twofold") {
  // The law promises a critically damped stiffest mode and half of its stability limit in reserve.
  for (const double share_of_mass : {1.0, 0.5}) {
    const friction::viscous_coulomb law{1e9, 0.4};
    friction::viscous_coulomb::contact_memory<double> memory{};
    double velocity = 1e-9;
    int turns = 0;
    for (int k = 0; k < 400; ++k) {
      const slip<double> s{{velocity, 0, 0}, {0, 0, 1}, mass, 1, 1e-6};
      const double before = velocity;
      velocity += 1e-6 / (share_of_mass * mass) * law.traction(s, 1.0, memory).x;
      if (std::abs(velocity) > 1e-15 && velocity * before < 0) ++turns;
    }
    CAPTURE(share_of_mass);
    CHECK(turns <= 1);
    CHECK(std::abs(velocity) < 1e-15);
  }
}

TEST_CASE("a grain on many stiff contacts comes to rest") {
  for (const int contacts : {1, 2, 6, 12}) {
    const friction::viscous_coulomb law{1e3, 0.4};
    friction::viscous_coulomb::contact_memory<double> memory{};  // the same for all, since all slip alike
    double velocity = 1e-9;
    for (int k = 0; k < 1000; ++k) {
      const slip<double> s{{velocity, 0, 0}, {0, 0, 1}, mass, double(contacts), 1e-6};
      velocity += 1e-6 / mass * contacts * law.traction(s, 1.0, memory).x;
    }
    CAPTURE(contacts);
    CHECK(std::abs(velocity) < 1e-12);
  }
}

TEST_CASE("a contact that slid for long turns back at once") {
  const friction::viscous_coulomb law{10.0, 0.4};
  friction::viscous_coulomb::contact_memory<double> memory{};
  const auto traction = [&](double velocity) {
    return law.traction(slip<double>{{velocity, 0, 0}, {0, 0, 1}, mass, 1, 1e-6}, 1e-3, memory).x;
  };
  for (int k = 0; k < 10000; ++k) REQUIRE(traction(0.1) == within(1e-12, -4e-4));
  CHECK(norm(memory.elastic_force) <= 4e-4 * (1 + 1e-14));
  CHECK(traction(-0.1) == within(1e-12, 4e-4));
}

TEST_CASE("the explicit form beyond its limit is held by the cone only") {
  slider published{friction::viscous_coulomb_explicit{1.0, 0.4}, mass, 1e-3, 1e-6, 1e-6};
  double highest = 0;
  for (int k = 0; k < 1000; ++k) {
    published.step(0);
    highest = std::max(highest, std::abs(published.velocity));
  }
  // One capped impulse, mu N dt / m = 2e-3 m/s: the block rattles at up to that speed for ever.
  CHECK(highest <= 2e-3 * (1 + 1e-12));
  CHECK(std::abs(published.velocity) > 2e-4);
}

TEST_CASE("friction in float stays inside the cone and keeps the creep speed") {
  const friction::viscous_coulomb law{1.0, 0.4};
  friction::viscous_coulomb::contact_memory<float> memory{{0, 0, 0}};
  const slip<float> s{{1e-6f, 0.f, 0.f}, {0.f, 0.f, 1.f}, 2e-7f, 4.f, 1e-6};
  Vec3<float> force{};
  for (int k = 0; k < 10000; ++k) force = law.traction(s, 1e-3f, memory);
  CHECK(double(force.x) == within(1e-4, -1e-6));
  const slip<float> slow{{1e-25f, 1e-25f, 0.f}, {0.f, 0.f, 1.f}, 2e-7f, 4.f, 1e-6};
  CHECK(std::isfinite(law.traction(slow, 1e-3f, memory).x));
}

TEST_CASE("extreme viscosity and extreme load leave the traction finite") {
  for (const double viscosity : {1e-12, 1e12}) {
    for (const double normal_force : {1e-20, 1e12}) {
      boost::hana::for_each(both, [&](auto type) {
        const typename decltype(type)::type law{viscosity, 0.4};
        const Vec3<double> force = first_traction(law, Vec3<double>{1e3, 0, 0}, normal_force, 1e-6);
        CHECK(std::isfinite(force.x));
        CHECK(std::abs(force.x) <= 0.4 * normal_force * (1 + 1e-14));
      });
    }
  }
}

TEST_CASE("friction parameters without meaning are refused") {
  boost::hana::for_each(both, [](auto type) {
    using law = typename decltype(type)::type;
    CHECK_NOTHROW(validate(law{1.0, 0.0}));
    CHECK_THROWS_AS(validate(law{0.0, 0.4}), input_error);
    CHECK_THROWS_AS(validate(law{1.0, -0.4}), input_error);
    CHECK_THROWS_AS(validate(law{std::numeric_limits<double>::infinity(), 0.4}), input_error);
    CHECK_THROWS_AS(validate(law{1.0, std::nan("")}), input_error);
  });
}
