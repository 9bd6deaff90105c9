// SPDX-License-Identifier: BSD-3-Clause

// Friction, rotation and lever arms through the whole system: the sliding sphere of MFiX-DEM DEM04, the oblique and
// spinning impacts of Chung and Ooi 2011, a sphere on an incline, a grain creeping between two plates.
#include "scenes.hpp"

#include <algorithm>
#include <array>

using namespace pendular;
using namespace scenes;

namespace {

struct motion {
  vector velocity, spin;
};

/// One sphere against the floor: down with `normal_speed`, along x with `tangential_speed`, spinning about y.
template <class Material>
motion floor_impact(const Material& m, double r, double density, double normal_speed, double tangential_speed,
                    double spin_y, double dt) {
  pendular::system s{m, floor_plane(), velocity_verlet{dt}, run_options{.force = true}};
  s.add({{0, 0, r + 0.4 * normal_speed * dt}, r, density, {tangential_speed, 0, -normal_speed}, {0, spin_y, 0}});
  s.run(2);
  while (position(s, 0).z < r) s.run(1);
  return {velocity(s, 0), spin(s, 0)};
}

/// Two spheres head on along x, both spinning about z. `second_radius` and density may differ.
template <class Material>
std::array<motion, 2> pair_impact(const Material& m, const grain& a, const grain& b, double dt) {
  pendular::system s{m, boundary::walls{}, velocity_verlet{dt}, run_options{.force = true}};
  s.add(a);
  s.add(b);
  s.run(2);
  while (gap_of(s, 0, 1) < 0) s.run(1);
  return {motion{velocity(s, 0), spin(s, 0)}, motion{velocity(s, 1), spin(s, 1)}};
}

/// Friction laws that make visible what they are told.
struct mass_probe {
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T&) const {
    const T rate = T(-1e3) * s.tangential_mass;
    return rate * s.velocity;
  }
};
struct contact_probe {
  static constexpr bool counts_contacts = true;
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T&) const {
    const T rate = T(-1e-6) * s.contacts;
    return rate * s.velocity;
  }
};

// Chung and Ooi's e = 0.5 by a dashpot on approach only (physics 4.2), whose push never attracts: a two-sided one ends
// with an attractive push, on which Coulomb's law gives no friction, and the impulse ratio would not be mu.
constexpr double e = 0.5;
const material unsticky{normal::linear{4e8}, damping::viscous_on_approach{0.5973}, friction::coulomb_spring{4e10, 0.4}};

}  // namespace

TEST_CASE("DEM04: a sliding sphere ends at five sevenths of its speed, whatever the friction law") {
  const double r = 0.5e-3, rho = 1e4, u0 = 0.1, g = 9.81, k = 1e3;
  const double mass = sphere_mass(r, rho), sag = mass * g / k, lever = r - sag;
  // Angular momentum about the contact: m l v + I w = m l u0, and v = w l once it rolls. 5/7 for l = r.
  const double inertia_share = 0.4 * r * r / (lever * lever);
  const double final_speed = u0 / (1 + inertia_share);
  CHECK(final_speed == within(1e-4, 0.0714286));
  const auto check = [&](const auto& friction_law, double mu, double tail) {
    pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, friction_law}, floor_plane(),
                       velocity_verlet{2e-6, {0, 0, -g}}, run_options{.force = true}};
    s.add({{0, 0, lever}, r, rho, {u0, 0, 0}});
    const double slip_time = 2 * u0 / (7 * mu * g);
    s.run(std::llround(0.5 * slip_time / 2e-6));
    CHECK(velocity(s, 0).x == within(2e-4, u0 - mu * g * s.time()));
    CHECK(spin(s, 0).y == within(3e-4, 2.5 * mu * g * s.time() / r));
    double worst = 0;
    for (int n = 0; n < 200; ++n) {
      s.run(20);
      worst = std::max(
          worst, std::abs(mass * lever * velocity(s, 0).x + 0.4 * mass * r * r * spin(s, 0).y - mass * lever * u0));
    }
    CHECK(worst < 1e-9 * mass * lever * u0);
    s.run(std::llround((0.6 * slip_time + tail) / 2e-6));
    CAPTURE(mu, slip_time, velocity(s, 0).x, spin(s, 0).y);
    CHECK(velocity(s, 0).x == within(1e-4, final_speed));
    CHECK(spin(s, 0).y == within(1e-4, final_speed / lever));
    CHECK(spin(s, 0).y == within(3e-4, 142.857));
    CHECK(std::abs(velocity(s, 0).y) + std::abs(spin(s, 0).x) + std::abs(spin(s, 0).z) < 1e-15);
  };
  for (const double mu : {0.2, 0.5, 1.0}) {
    check(friction::coulomb_spring{800, mu}, mu, 0.02);
    check(friction::viscous_coulomb{1, mu}, mu, 1e-3);
    // Inside its bound gamma dt < 2/7 m; the tail decays with 2 m / (7 gamma) = 3 us.
    check(friction::viscous_coulomb_explicit{0.5, mu}, mu, 1e-3);
  }
}

TEST_CASE("DEM04: the end of sliding is where 2 u0 / (7 mu g) says") {
  const double r = 0.5e-3, rho = 1e4, u0 = 0.1, g = 9.81, k = 1e3, sag = sphere_mass(r, rho) * g / k;
  const std::array<std::array<double, 2>, 3> table{{{0.2, 14.56e-3}, {0.5, 5.825e-3}, {1.0, 2.912e-3}}};
  for (const auto& [mu, expected] : table) {
    pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, friction::viscous_coulomb{1, mu}},
                       floor_plane(), velocity_verlet{2e-6, {0, 0, -g}}, run_options{.force = true}};
    s.add({{0, 0, r - sag}, r, rho, {u0, 0, 0}});
    while (velocity(s, 0).x - spin(s, 0).y * r > 1e-3 * u0) s.run(1);
    CHECK(s.time() == within(3e-3, expected));
  }
}

TEST_CASE("Chung and Ooi 4: oblique impacts that slide throughout follow the impulse ratio mu") {
  // R = 2.5 mm, 380 GPa, 0.23, 4000 kg/m3, 3.9 m/s, e = 0.98, mu = 0.092.
  const double r = 2.5e-3, mu = 0.092, bounce = 0.98, speed = 3.9;
  const double rate = std::sqrt(5.0 / 6) * damping_rate_for(bounce);
  // Spin values to be found: physics 4.7 F. Angle, e_t, spin (rad/s).
  const std::array<std::array<double, 3>, 6> table{{{40, .7829, 544.2},
                                                    {50, .8471, 456.7},
                                                    {60, .8948, 355.2},
                                                    {70, .9337, 243.0},
                                                    {80, .9679, 123.4},
                                                    {85, .9841, 61.9}}};
  for (const auto& [degrees, expected_ratio, expected_turn] : table) {
    const double ratio = expected_ratio, turn = expected_turn;  // clang 14 captures no structured binding
    const double angle = degrees * pi / 180, vn = speed * std::cos(angle), vt = speed * std::sin(angle);
    const auto check = [&](const auto& friction_law) {
      const material m{normal::hertz{380e9, 0.23}, damping::viscous{rate}, friction_law};
      const motion after = floor_impact(m, r, 4000, vn, vt, 0, 1e-8);
      CHECK(after.velocity.z / vn == near(2e-3, bounce));
      CHECK(after.velocity.x / vt == near(5e-4, ratio));
      // Forward is positive about y above the floor. The overlap shortens the lever arm by up to 0.8 %.
      CHECK(after.spin.y == within(4e-3, turn));
      CHECK(std::abs(after.velocity.y) + std::abs(after.spin.x) + std::abs(after.spin.z) < 1e-12);
    };
    check(friction::coulomb_spring{3e8, mu});
    check(friction::viscous_coulomb_explicit{1e3, mu});
  }
}

TEST_CASE("Chung and Ooi 4: viscous friction that sticks keeps five sevenths of the tangential speed") {
  const double r = 2.5e-3, vn = 3.9 * std::cos(pi / 18), vt = 3.9 * std::sin(pi / 18);
  const double rate = std::sqrt(5.0 / 6) * damping_rate_for(0.98);
  const material m{normal::hertz{380e9, 0.23}, damping::viscous{rate}, friction::viscous_coulomb{3e4, 0.3}};
  const motion after = floor_impact(m, r, 4000, vn, vt, 0, 1e-9);
  CHECK(after.velocity.x / vt == near(2e-3, 5.0 / 7));
  CHECK((after.velocity.x - after.spin.y * r) / vt == near(3e-3, 0.0));
}

TEST_CASE("Chung and Ooi 5 and 6: contact slip after a gross-sliding impact is s - 7/2 mu (1 + e) v_n") {
  SECTION("steel, 10 um, incident at an angle") {
    const double r = 1e-5, vn = 5, mu = 0.3;
    for (const double tangent : {2.5, 4.0, 10.0}) {
      const material m{normal::hertz{208e9, 0.3}, friction::coulomb_spring{2e7, mu}};
      const motion after = floor_impact(m, r, 7850, vn, vn * tangent, 0, 2e-11);
      const double slip = after.velocity.x - after.spin.y * r;
      CHECK(after.velocity.z == within(1e-4, vn));
      // The overlap shortens the lever arm by up to 1 %.
      CHECK(vn * tangent - slip == within(1e-2, 3.5 * mu * 2 * vn));
    }
  }
  SECTION("aluminium alloy, 0.1 m, spinning") {
    const double r = 0.1, vn = 0.2, mu = 0.4;
    for (const double tangent : {3.0, 6.0}) {
      const double spin0 = vn * tangent / r;
      const motion after = floor_impact(unsticky, r, 2700, vn, 0, spin0, 1e-7);
      CHECK(after.velocity.z == within(2e-3, e * vn));
      // A positive spin about y drags the contact point towards -x, so the floor pushes towards +x.
      CHECK(after.velocity.x == within(3e-3, mu * (1 + e) * vn));
      CHECK(after.spin.y == within(3e-3, spin0 - 2.5 * mu * (1 + e) * vn / r));
    }
  }
}

TEST_CASE("Chung and Ooi 7: opposite spins of two equal spheres slide nowhere, equal spins do") {
  const double r = 0.1, vn = 0.2, mu = 0.4;
  const double dt = 1e-7, half_gap = 0.3 * vn * dt;
  const auto run = [&](double spin_a, double spin_b) {
    return pair_impact(unsticky, {{-r - half_gap, 0, 0}, r, 2700, {vn, 0, 0}, {0, 0, spin_a}},
                       {{r + half_gap, 0, 0}, r, 2700, {-vn, 0, 0}, {0, 0, spin_b}}, dt);
  };
  const double spin0 = 5 * vn / r;
  const auto geared = run(spin0, -spin0);
  for (const motion& after : geared) {
    CHECK(std::abs(after.spin.z) == within(1e-12, spin0));
    CHECK(std::abs(after.velocity.y) < 1e-12 * vn);
    CHECK(std::abs(after.velocity.x) == within(2e-3, e * vn));
  }
  const auto rubbing = run(spin0, spin0);
  // The surface of the left sphere goes up, that of the right one down: the left sphere is pushed down.
  CHECK(rubbing[0].velocity.y == within(3e-3, -mu * (1 + e) * vn));
  CHECK(rubbing[1].velocity.y == within(3e-3, mu * (1 + e) * vn));
  for (const motion& after : rubbing) CHECK(after.spin.z == within(1e-3, spin0 - 2.5 * mu * (1 + e) * vn / r));
}

TEST_CASE("Chung and Ooi 8: a spinning sphere hits a larger heavy one") {
  const double r = 0.1, big = 0.5, vn = 0.2, mu = 0.4;
  const double dt = 1e-7, spin0 = 5 * vn / r, light = sphere_mass(r, 2700), heavy = sphere_mass(big, 2.7e6);
  const auto after = pair_impact(unsticky, {{-r - 0.3 * vn * dt, 0, 0}, r, 2700, {vn, 0, 0}, {0, 0, spin0}},
                                 {{big, 0, 0}, big, 2.7e6}, dt);
  const double impulse = light * heavy / (light + heavy) * (1 + e) * vn;
  CHECK(after[0].velocity.x == within(3e-3, vn - impulse / light));
  CHECK(after[0].velocity.y == within(3e-3, -mu * impulse / light));
  CHECK(after[0].spin.z == within(3e-3, spin0 - 2.5 * mu * impulse / light / r));
  CHECK(after[1].velocity.y == within(3e-3, mu * impulse / heavy));
  CHECK(after[1].spin.z == within(3e-3, -2.5 * mu * impulse / heavy / big));
}

TEST_CASE("angular momentum of two unlike spheres is kept to round-off by friction and lost by nothing else") {
  const material m{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}};
  pendular::system s{m, boundary::walls{}, velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({{0, 0, 0}, 0.5e-3, 2600, {0.05, 0.02, -0.01}, {20, -40, 60}});
  s.add({{0.2e-3, 0.1e-3, 1.501e-3}, 1e-3, 2600, {-0.02, 0, -0.06}, {-5, 70, 10}});
  const auto angular_momentum = [&] {
    vector sum{0, 0, 0};
    for (std::int64_t id : {0, 1}) {
      const double r = id == 0 ? 0.5e-3 : 1e-3, mass = sphere_mass(r, 2600);
      sum += mass * cross(position(s, id), velocity(s, id)) + (0.4 * mass * r * r) * spin(s, id);
    }
    return sum;
  };
  s.start();
  const vector before = angular_momentum();
  const double spin_before = spin(s, 0).z;
  s.run(4000);
  CHECK(norm(angular_momentum() - before) < 1e-11 * norm(before));
  CHECK(std::abs(spin(s, 0).z - spin_before) > 1);  // they did touch and rub
}

TEST_CASE("a sphere on an incline rolls below 7/2 mu and slides above") {
  const double r = 0.5e-3, k = 1e3, g = 9.81, mu = 0.2, mass = sphere_mass(r, 2600);
  for (const double degrees : {20.0, 30.0, 45.0, 60.0}) {  // tan = 0.7 at 35 degrees
    const double beta = degrees * pi / 180, sag = mass * g * std::cos(beta) / k;
    const auto check = [&](const auto& friction_law, double tolerance) {
      pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, friction_law}, floor_plane(),
                         velocity_verlet{2e-6, {g * std::sin(beta), 0, -g * std::cos(beta)}},
                         run_options{.force = true}};
      s.add({{0, 0, r - sag}, r, 2600});
      s.run(10000);
      const double t = s.time();
      CAPTURE(degrees);
      if (std::tan(beta) < 3.5 * mu) {
        CHECK(velocity(s, 0).x / t == within(tolerance, 5.0 / 7 * g * std::sin(beta)));
        CHECK(spin(s, 0).y * r / t == within(tolerance, 5.0 / 7 * g * std::sin(beta)));
      } else {
        CHECK(velocity(s, 0).x / t == within(tolerance, g * (std::sin(beta) - mu * std::cos(beta))));
        CHECK(spin(s, 0).y / t == within(tolerance, 2.5 * mu * g * std::cos(beta) / r));
      }
    };
    check(friction::coulomb_spring{800, mu}, 2e-3);
    check(friction::viscous_coulomb{1, mu}, 2e-3);
  }
}

TEST_CASE("a grain held between two plates creeps at exactly F over twice gamma_t, at every time step") {
  // The two tractions turn the grain in opposite senses, so its rotation is blocked without a constraint. Eq. 12 at the
  // companion paper's gamma_t = 1 N s/m and beyond; the explicit form is unstable at these steps.
  const double r = 0.5e-3, k = 1e3, g = 9.81, squeeze = 1e-6, mass = sphere_mass(r, 2600);
  for (const double gamma : {0.1, 1.0, 1e3}) {
    for (const double dt : {1e-7, 1e-6, 5e-6}) {
      pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, friction::viscous_coulomb{gamma, 0.4}},
                         boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                                         boundary::wall{boundary::plane{{0, 0, 2 * (r - squeeze)}, {0, 0, -1}}}},
                         velocity_verlet{dt, {g, 0, 0}}, run_options{.force = true}};
      s.add({{0, 0, r - squeeze}, r, 2600});
      CHECK(mass * g < 0.4 * 2 * k * squeeze);  // else it slides
      // 30 relaxation times of the dashpots or of the numerical elements, whichever is longer
      s.run(std::llround(30 * mass / (2 * gamma) / dt) + 3000);
      const double expected = mass * g / (2 * gamma);
      CAPTURE(gamma, dt, velocity(s, 0).x / expected);
      // The last term is rounding: the velocity is a small difference of impulses.
      CHECK(velocity(s, 0).x == within(1e-8 + 1e-15 * gamma * dt / mass, expected));
      CHECK(std::abs(spin(s, 0).y) * r < 1e-9 * std::abs(velocity(s, 0).x) + 1e-18);
    }
  }
}

TEST_CASE("two plates in counter-motion drag a grain's surface apart with the Coulomb force") {
  // Each plate slides at 10 cm/s over the grain that turns to follow both: it rolls without slip and feels no drag.
  const double r = 0.5e-3, k = 1e3, squeeze = 1e-6, u = 0.1;
  using boundary::constant_velocity;
  using boundary::plane;
  pendular::system s{
      material{normal::linear{k}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}},
      boundary::walls{boundary::wall{plane{{0, 0, 0}, {0, 0, 1}}, constant_velocity{{-u, 0, 0}}},
                      boundary::wall{plane{{0, 0, 2 * (r - squeeze)}, {0, 0, -1}}, constant_velocity{{u, 0, 0}}}},
      half_step_velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({{0, 0, r - squeeze}, r, 2600});
  double drag = 0;
  for (int n = 0; n < 20; ++n) {
    s.run(1);
    drag = std::max(drag, norm(boundary::get<0>(s.walls()).force - vector{0, 0, boundary::get<0>(s.walls()).force.z}));
  }
  CHECK(drag == within(1e-6, 0.4 * k * squeeze));
  double mean = 0;
  s.run(20000);
  for (int n = 0; n < 2000; ++n) {
    s.run(1);
    mean += spin(s, 0).y / 2000;
  }
  CHECK(mean * (r - squeeze) == within(0.02, u));
  CHECK(std::abs(velocity(s, 0).x) < 1e-10);
}

TEST_CASE("a loaded friction spring turns with the spin of its pair about the normal") {
  // Grains so heavy that no force moves them; sliding along x loads the spring, then both turn about the normal z.
  pendular::system s{material{normal::linear{1e3}, friction::coulomb_spring{800, 0.4}}, boundary::walls{},
                     velocity_verlet{1e-6}, run_options{.force = true}};
  const double r = 0.5e-3, heavy = 1e12;
  s.add({{0, 0, 0}, r, heavy, {1e-3, 0, 0}});
  s.add({{0, 0, 2 * r - 1e-6}, r, heavy});
  s.run(100);
  const vector loaded = s.contacts().force(0);
  CHECK(loaded.x == within(2e-2, -800 * 1e-3 * 101e-6));
  position(s, 0) = velocity(s, 0) = {0, 0, 0};
  const double turn = 0.5 * pi, steps = 2000;
  spin(s, 0).z = spin(s, 1).z = turn / (steps * 1e-6);
  s.run(static_cast<std::int64_t>(steps));
  const vector turned = s.contacts().force(0);
  CHECK(turned.y == within(2e-3, loaded.x));
  CHECK(std::abs(turned.x) < 5e-3 * std::abs(loaded.x));
  CHECK(turned.z == within(1e-4, loaded.z));
}

TEST_CASE("a loaded friction spring follows its contact when the pair swings round") {
  // Both grains circle their common centre about y without spin relative to the line of centres: no slip, so the
  // traction keeps its size and stays in the tangent plane.
  pendular::system s{material{normal::linear{1e3}, friction::coulomb_spring{800, 0.4}}, boundary::walls{},
                     velocity_verlet{1e-6}, run_options{.force = true}};
  const double r = 0.5e-3, heavy = 1e12, half = r - 0.5e-6;
  s.add({{0, 0, -half}, r, heavy, {1e-3, 0, 0}});
  s.add({{0, 0, half}, r, heavy});
  s.run(100);
  const double before = std::abs(s.contacts().force(0).x);
  position(s, 0) = {0, 0, -half};
  const double rate = 0.5 * pi / 8000e-6;
  for (int n = 1; n <= 8000; ++n) {
    const double angle = rate * n * 1e-6;
    const vector along{std::sin(angle), 0, std::cos(angle)}, across{std::cos(angle), 0, -std::sin(angle)};
    position(s, 0) = (-half) * along;
    position(s, 1) = half * along;
    velocity(s, 0) = (-half * rate) * across;
    velocity(s, 1) = (half * rate) * across;
    spin(s, 0) = spin(s, 1) = {0, rate, 0};
    s.run(1);
  }
  const vector after = s.contacts().force(0);
  CHECK(after.z == within(2e-2, before));       // x has turned into -z, and the force on grain 0 pointed to -x
  CHECK(after.x == within(1e-2, -1e3 * 1e-6));  // the normal push
}

TEST_CASE("a friction law sees two sevenths of the reduced mass, of the grain's own at a wall") {
  const double r = 0.5e-3, v = 1e-3, small = sphere_mass(r, 2600), large = 8 * small;
  pendular::system s{material{normal::linear{1e3}, mass_probe{}}, floor_plane(), velocity_verlet{1e-9},
                     run_options{.force = true}};
  s.add({{0, 0, 10 * r}, r, 2600, {v, 0, 0}});
  s.add({{0, 0, 13 * r}, 2 * r, 2600});
  s.add({{0.1, 0, r}, r, 2600, {v, 0, 0}});
  s.start();
  CHECK(s.contacts().force(0).x == within(1e-12, -1e3 * v * 2 / 7 * small * large / (small + large)));
  CHECK(boundary::get<0>(s.walls()).force.x == within(1e-12, 1e3 * v * 2 / 7 * small));
}

TEST_CASE("a friction law that counts contacts sees the mean of its two grains, walls included") {
  // Floor - 0 - 1 - 2, all touching: 2, 2 and 1 contacts.
  const double r = 0.5e-3, v = 1e-3, d = 2 * r - 1e-9;
  pendular::system s{material{normal::linear{1e3}, contact_probe{}}, floor_plane(), velocity_verlet{1e-12},
                     run_options{.force = true}};
  for (int k = 0; k < 3; ++k) s.add({{0, 0, r - 1e-9 + k * d}, r, 2600, {k == 1 ? v : 0.0, 0, 0}});
  s.run(2);
  for (std::size_t p = 0; p < 2; ++p) {
    const auto view = s.view();
    const bool lower = view.id[view.grain_i(p)] == 0;
    CHECK(s.contacts().force(p).x == within(1e-6, (lower ? 2.0 : -1.5) * 1e-6 * v));
  }
}
