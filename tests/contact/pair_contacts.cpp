// SPDX-License-Identifier: BSD-3-Clause
// Forces and torques of listed pairs, and what moving them does to the grains, in numbers worked out by hand.
#include "../catch.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>

using namespace pendular;

namespace {
const double kilogram = 3 / (4 * std::numbers::pi);  // density of a grain of 1 kg and 1 m
constexpr run_options unchecked{.overlap_limit = 0.9, .force = true};

/// A spring as stiff as the pair is heavy, 1/s2 kg: a law that looks at the reduced mass where nobody keeps it.
struct heavy_spring {
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    return T(100) * a.reduced_mass * max(T(-a.gap), T(0));
  }
};

template <class Material>
auto scene_of(const Material& m) {
  return pendular::system{m, boundary::walls{}, velocity_verlet{1e-3}, unchecked};
}
}  // namespace

TEST_CASE("two grains push each other apart along the line of their centres") {
  auto s = scene_of(material{normal::linear{100}});
  s.add({{0, 0, 0}, 1, kilogram});
  s.add({{0.6 * 1.9, 0, 0.8 * 1.9}, 1, kilogram});
  s.start();
  REQUIRE(s.pairs().size() == 1);
  CHECK(s.contacts().gap()[0] == near(1e-14, -0.1));
  CHECK(s.contacts().force(0).x == within(1e-12, -6));
  CHECK(s.contacts().force(0).z == within(1e-12, -8));
  const auto force = s.particles().get<column::force>();
  CHECK(force[0].z == within(1e-12, -8));
  CHECK(force[0] + force[1] == vector{0, 0, 0});
}

TEST_CASE("the dashpot takes the reduced mass and the closing speed") {
  // 1 kg and 3 kg (radius 1, three times the density): m = 0.75; 2 0.5 sqrt(0.75 * 300) = 15 N s/m
  auto s = scene_of(material{normal::linear{300}, damping::viscous{0.5}});
  s.add({{0, 0, 0}, 1, kilogram, {0.2, 5, 0}});
  s.add({{1.9, 0, 0}, 1, 3 * kilogram, {-0.2, -5, 0}});
  s.start();
  CHECK(s.contacts().force(0).x == within(1e-12, -(30 + 15 * 0.4)));
  CHECK(s.contacts().force(0).y == 0);
}

TEST_CASE("a normal law is told the reduced mass though nothing keeps it, of pairs, of held grains and at walls") {
  static_assert(std::is_empty_v<contact_constants<double, material<heavy_spring>>>);
  // 1 kg and 3 kg: m = 0.75; 3 kg alone if the other is held; the grain's own mass at the floor
  pendular::system s{material{heavy_spring{}}, boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                     velocity_verlet{1e-6}, unchecked};
  s.add({{0, 0, 5}, 1, kilogram});
  s.add({{1.9, 0, 5}, 1, 3 * kilogram});
  s.add({{0, 10, 0.9}, 1, 2 * kilogram});
  s.start();
  REQUIRE(s.pairs().size() == 1);
  CHECK(s.contacts().force(0).x == within(1e-12, -7.5));
  CHECK(s.particles().get<column::force>()[s.particles().row_of(2)].z == within(1e-12, 20));
  s.drive(0);
  s.run(1);
  CHECK(s.contacts().force(0).x == within(1e-6, -30));
  s.release(0);
  s.run(1);
  CHECK(s.contacts().force(0).x == within(1e-6, -7.5));
}

TEST_CASE("a friction spring is gone once its contact has opened, also if the forces were only looked at meanwhile") {
  for (const bool looked_at : {false, true}) {
    pendular::system s{material{normal::linear{100}, friction::coulomb_spring{1000, 0.5}},
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}}, boundary::walls{},
                       velocity_verlet{1e-3}, unchecked};
    s.add({{0, 0, 0}, 1, kilogram, {0, 1, 0}});
    s.add({{1.99, 0, 0}, 1, kilogram});
    s.run(3);
    REQUIRE(s.contacts().gap()[0] < 0);
    REQUIRE(norm(s.contacts().memories().row(0).elastic_force) > 0);
    s.particles().get<column::position>()[1].x += 0.05;  // apart, within the skin
    if (looked_at) s.distribute_liquid(0);
    s.run(1);
    REQUIRE(s.contacts().gap()[0] > 0);
    CHECK(norm(s.contacts().memories().row(0).elastic_force) == 0);
    CHECK(s.contacts().force(0) == vector{0, 0, 0});
    s.run(5);
    CHECK(s.particles().get<column::torque>()[0] == vector{0, 0, 0});
  }
}

TEST_CASE("friction opposes slip and turns both grains the same way") {
  // Spring of 1 kN/m drawn for 1 ms by the slip of the surfaces; levers of 0.95 and 1.95 m.
  auto s = scene_of(material{normal::linear{100}, friction::coulomb_spring{1000, 0.5}});
  s.add({{0, 0, 0}, 1, kilogram, {0, 1, 0}, {0, 0, 2}});
  s.add({{2.9, 0, 0}, 2, kilogram, {0, -1, 0}, {0, 0, -1}});
  s.start();
  // slip along y: 1 + 1 + 0.95 * 2 - 1.95 * 1 = 1.95 m/s
  CHECK(s.contacts().force(0).x == within(1e-12, -10));
  CHECK(s.contacts().force(0).y == within(1e-12, -1.95));
  const auto torque = s.particles().get<column::torque>();
  CHECK(torque[0].z == within(1e-12, -1.95 * 0.95));
  CHECK(torque[1].z == within(1e-12, -1.95 * 1.95));
  CHECK((torque[0].x == 0 && torque[0].y == 0));
}

TEST_CASE("grains that do not touch exert nothing, and padding is not counted") {
  auto s =
      scene_of(material{normal::linear{100}, damping::viscous{0.5}, friction::viscous_coulomb{10, 0.5}, energy_book{}});
  s.add({{0, 0, 0}, 1, kilogram, {1, 1, 0}, {1, 2, 3}});
  s.add({{2.05, 0, 0}, 1, kilogram, {-1, 0, 0}});
  s.add({{0, 0, 1.9}, 1, kilogram});
  s.start();
  REQUIRE(s.pairs().size() == 2);
  const auto rows = s.particles().rows_by_id();
  CHECK(s.particles().get<column::force>()[rows[1]] == vector{0, 0, 0});
  CHECK(s.particles().get<column::contacts>()[rows[0]] == 1);
  CHECK(s.particles().get<column::contacts>()[rows[1]] == 0);
  CHECK(s.particles().get<column::contacts>()[rows[2]] == 1);
}

TEST_CASE("looking at the forces of a scene twice changes nothing in it: no time has passed") {
  // What the start evaluates must not draw springs or dissipate work, for grains that have not moved yet.
  auto s = scene_of(
      material{normal::linear{100}, damping::viscous{0.5}, friction::coulomb_spring{1000, 0.5}, energy_book{}});
  s.add({{0, 0, 0}, 1, kilogram, {0.1, 1, 0}});
  s.add({{1.9, 0, 0}, 1, kilogram});
  s.start();
  CHECK(s.contacts().work().total().damping == 0);
  CHECK(s.contacts().work().total().friction == 0);
  CHECK(s.contacts().memories().row(0).elastic_force == vector{0, 0, 0});
}

TEST_CASE("the work of dashpot and friction is what leaves the motion") {
  // A short glancing collision: kinetic + elastic + spring + dissipated stays.
  for (const double time_step : {1e-4, 5e-5}) {
    pendular::system s{
        material{normal::linear{1e4}, damping::viscous{0.2}, friction::coulomb_spring{8e3, 0.5}, energy_book{}},
        boundary::walls{}, half_step_velocity_verlet{time_step}, unchecked};
    s.add({{0, 0, 0}, 1, kilogram, {1, 0.3, 0}, {0, 0, 1}});
    s.add({{2.02, 0.1, 0}, 1, kilogram, {-1, 0, 0.2}});
    s.start();
    const auto kinetic = [&] {
      double sum = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        const vector v = s.particles().get<column::velocity>()[k], w = s.particles().get<column::angular_velocity>()[k];
        sum += 0.5 * dot(v, v) + 0.2 * dot(w, w);  // 1 kg, 0.4 kg m2
      }
      return sum;
    };
    const double before = kinetic();
    s.run(static_cast<std::int64_t>(0.15 / time_step));
    REQUIRE(s.contacts().gap()[0] > 0);
    const auto work = s.contacts().work().total();
    CHECK((work.damping > 0.1 && work.friction > 0.01));
    CHECK(kinetic() + work.damping + work.friction == within(1e-2 * time_step / 1e-4, before));
  }
}

TEST_CASE("an overlap beyond the limit and coinciding centres stop the run, named by grain and step") {
  const auto message = [](double distance) -> std::string {
    pendular::system s{material{normal::linear{100}}, boundary::walls{}, velocity_verlet{1e-3},
                       run_options{.force = true}};
    s.add({{0, 0, 0}, 1, kilogram});
    s.add({{50, 0, 0}, 1, kilogram});
    s.add({{distance, 0, 0}, 1, kilogram});
    try {
      s.start();
    } catch (const run_error& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK(message(1.95) == "accepted");
  CHECK(message(1.5).find("grain 0 at step 0 overlaps grain 2 by 0.5 of its radius") != std::string::npos);
  CHECK(message(0).find("grain") != std::string::npos);
}

TEST_CASE("a grain that no wall holds is lost with a message that says where") {
  pendular::system s{material{normal::linear{100}}, boundary::walls{}, velocity_verlet{1e-3},
                     run_options{.domain_margin = 0.1, .force = true}};
  s.add({{0, 0, 0}, 1, kilogram, {0, 0, 0}});
  s.add({{5, 0, 0}, 1, kilogram, {0, 0, 1e4}});
  try {
    s.run(1000);
    FAIL("not lost");
  } catch (const run_error& error) {
    CHECK(std::string(error.what()).find("grain 1 at step") != std::string::npos);
    CHECK(std::string(error.what()).find("is lost at (5, 0, ") != std::string::npos);
  }
}
