// SPDX-License-Identifier: BSD-3-Clause
// The limit of the time step against the integrators themselves: grains held together by a constant pull, undamped and
// without sliding, run just below it and just above.
#include "../catch.hpp"

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/law/capillary/constant.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace pendular;

namespace {
constexpr double r = 0.5e-3, rho = 2600, stiff = 1e3, pull = 1e-3 * stiff * r;
using place = std::vector<vector>;

template <class System>
double kinetic(const System& s) {
  const auto& g = s.particles();
  double sum = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const vector v = g.template get<column::velocity>()[k];
    sum += 0.5 * dot(v, v) / g.template get<column::inverse_mass>()[k];
    if constexpr (System::grains_type::rotate) {
      const double radius = g.template get<column::radius>()[k];
      const vector w = g.template get<column::angular_velocity>()[k];
      sum += 0.2 * radius * radius * dot(w, w) / g.template get<column::inverse_mass>()[k];
    }
  }
  return sum;
}

run_options unchecked() { return {.overlap_limit = 0.9, .domain_margin = 1e6, .force = true}; }

/// By how much the kinetic energy grows over 2000 steps of this many limits, after a push in all directions.
template <class System>
double growth_of(System s, double limits) {
  auto integrator = s.integrator();
  integrator.time_step = limits * s.limits()[0].bound;
  s.change_integrator(integrator);
  double turn = 1;
  for (vector& v : s.particles().template get<column::velocity>()) {
    v = {1e-6 * std::sin(turn), 1e-6 * std::sin(2.3 * turn), 1e-6 * std::cos(1.7 * turn)};
    turn += 1;
  }
  const double before = kinetic(s);
  s.run(2000);
  return kinetic(s) / before;
}

/// Of equal grains held together by a constant pull.
template <class Integration, class Material>
double growth(const Material& m, const place& centres, double limits) {
  const fluid glue{pull / (2 * std::numbers::pi * r), 0, 1000, 0};
  pendular::system s{m, liquid{glue, capillary::constant{}, rupture::lian{}}, boundary::walls{}, Integration{1e-9},
                     unchecked()};
  for (const vector& c : centres) s.add({c, r, rho});
  s.distribute_liquid(0.1 * r * r * r * static_cast<double>(centres.size()));
  return growth_of(std::move(s), limits);
}

place chain(int count) {
  place all;
  for (int k = 0; k < count; ++k) all.push_back({k * (2 * r - pull / stiff), 0, 0});
  return all;
}

/// Face-centred cubic, two cells wide.
place crystal() {
  const double a = (2 * r - pull / stiff) * std::numbers::sqrt2;
  place all;
  for (int cell = 0; cell < 8; ++cell) {
    const vector corner{cell & 1 ? a : 0, cell & 2 ? a : 0, cell & 4 ? a : 0};
    for (const vector& c : {vector{0, 0, 0}, {0, 0.5 * a, 0.5 * a}, {0.5 * a, 0, 0.5 * a}, {0.5 * a, 0.5 * a, 0}}) {
      all.push_back(corner + c);
    }
  }
  return all;
}

template <class Integration>
void stable_below_its_limit(double tangential) {
  const material sticky{normal::linear{stiff}, friction::coulomb_spring{tangential * stiff, 100}};
  CAPTURE(Integration::velocity_lag, tangential);
  for (const place& centres : {chain(2), chain(10), crystal()}) {
    CAPTURE(centres.size());
    CHECK(growth<Integration>(sticky, centres, 0.995) < 100);
  }
  CHECK(growth<Integration>(sticky, chain(2), 1.02) > 1e3);
}
}  // namespace

TEST_CASE("packings with friction springs are stable up to the limit, a pair not beyond it") {
  for (const double tangential : {0.1, 0.3, 0.8, 2.0}) {
    stable_below_its_limit<velocity_verlet>(tangential);
    stable_below_its_limit<half_step_velocity_verlet>(tangential);
  }
}

TEST_CASE("so are grains of very different mass and a grain on a wall") {
  const auto check = []<class Integration>(Integration) {
    CAPTURE(Integration::velocity_lag);
    const material sticky{normal::linear{stiff}, friction::coulomb_spring{0.8 * stiff, 100}};
    const double mass = 4.0 / 3 * std::numbers::pi * r * r * r * rho;
    // Each is pressed on what holds it by a weight of `pull`.
    pendular::system floor{sticky, boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                           Integration{1e-9, {0, 0, -pull / mass}}, unchecked()};
    floor.add({{0, 0, r - pull / stiff}, r, rho});
    floor.start();
    CHECK(growth_of(floor, 0.995) < 100);
    CHECK(growth_of(floor, 2.05) > 1e3);  // counted besides: the neighbour that it has not
    const fluid glue{pull / (2 * std::numbers::pi * 1.5 * r), 0, 1000, 0};  // of a harmonic mean of 1.5 r
    pendular::system pair{sticky, liquid{glue, capillary::constant{}, rupture::lian{}}, boundary::walls{},
                          Integration{1e-9}, unchecked()};
    pair.add({{0, 0, 0}, r, rho});
    pair.add({{4 * r - pull / stiff, 0, 0}, 3 * r, rho});
    pair.distribute_liquid(0.1 * r * r * r);
    CHECK(growth_of(pair, 0.995) < 100);
    CHECK(growth_of(pair, 1.5) > 1e3);
  };
  check(velocity_verlet{1});
  check(half_step_velocity_verlet{1});
}

TEST_CASE("packings with springs and dashpots are stable up to the limit") {
  for (const double rate : {0.0, 0.5, 0.9}) {
    const material m{normal::linear{stiff}, damping::viscous{rate}, friction::coulomb_spring{0.8 * stiff, 100}};
    CAPTURE(rate);
    CHECK(growth<velocity_verlet>(m, crystal(), 0.995) < 100);
    CHECK(growth<half_step_velocity_verlet>(m, crystal(), 0.995) < 100);
  }
}

namespace {
/// A lid at rest on a heavy grain that it presses with 0.1 N.
auto lid_on_heavy_grain(double mass, double damping, double step) {
  const boundary::wall lid{boundary::plane{{0, 0, 2 * r - 0.99e-4}, {0, 0, -1}},
                           boundary::servo_stress{0.1, 1, mass, damping}};
  pendular::system s{material{normal::linear{stiff}}, boundary::walls{lid}, half_step_velocity_verlet{step},
                     unchecked()};
  s.add({{0, 0, r}, r, 1e9});
  s.start();
  return s;
}

scene_limit lid_limit(double mass, double damping, double step) {
  for (const scene_limit& l : lid_on_heavy_grain(mass, damping, step).limits()) {
    if (l.what.find("mass of a lid") != std::string::npos) return l;
  }
  FAIL("no limit for lids");
  return {};
}

double largest_force(double mass, double damping, double step) {
  auto s = lid_on_heavy_grain(mass, damping, step);
  double most = 0;
  for (int k = 0; k < 300; ++k) {
    s.run(1);
    most = std::max(most, norm(boundary::get<0>(s.walls()).force));
  }
  return most;
}
}  // namespace

TEST_CASE("a lid on a heavy grain is stable up to its limit and not beyond 1.42 of it") {
  const double limit = lid_limit(1e-7, 0, 1e-9).bound;
  CHECK(largest_force(1e-7, 0, 0.995 * limit) < 0.11);
  CHECK(largest_force(1e-7, 0, 1.40 * limit) < 0.2);
  CHECK_THROWS_AS(largest_force(1e-7, 0, 1.45 * limit), run_error);
}

TEST_CASE("so is a light lid with a dashpot, which takes longer steps") {
  // 2 k dt^2 = 4 m + 2 c dt at dt = (c + sqrt(c^2 + 8 m k)) / (2 k) = 1e-4 s; of the lid alone, with one k, it is 2e-4 s.
  const double mass = 1e-11, damping = 0.1, step = 1e-4;
  CHECK(lid_limit(mass, damping, 0.999 * step).holds());
  CHECK_FALSE(lid_limit(mass, damping, 1.001 * step).holds());
  CHECK(largest_force(mass, damping, 0.999 * step) < 0.11);
  CHECK(largest_force(mass, damping, 1.98 * step) < 0.11);
  CHECK(largest_force(mass, damping, 2.02 * step) > 0.19);  // it leaves the grain and falls back
}
