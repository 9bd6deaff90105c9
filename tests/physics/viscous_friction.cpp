// SPDX-License-Identifier: BSD-3-Clause

// Eq. 12 in dense packings at the companion paper's gamma_t = 1 N s/m and beyond (physics 0.1): the published explicit
// form is the truth where its step is inside its own bound, gamma_t dt n < m_t; the stable form must come to the same
// answer as dt -> 0 and must not gain energy at any step.
#include "scenes.hpp"

#include <algorithm>
#include <array>

using namespace pendular;
using namespace scenes;

namespace {

const vector gravity_down{0, 0, -9.81};
constexpr double side = 8 * 1.02e-3;  // m

/// About 500 settled grains in a box, made once.
const std::vector<grain>& settled() {
  static const std::vector<grain> all = [] {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.6}, friction::coulomb_spring{800, 0.1}},
                       closed_box({side, side, 20e-3}), velocity_verlet{8e-6, gravity_down},
                       run_options{.force = true}};
    for (const grain& g : loose_lattice(7, 7, 10, 0.5e-3, 0.08, 1.165e-3, 0.1)) s.add(g);
    s.run(25000);
    std::vector<grain> grains;
    for (const std::size_t row : s.particles().rows_by_id()) {
      grain g = s.particles()[row];
      g.velocity = g.angular_velocity = {0, 0, 0};
      grains.push_back(g);
    }
    return grains;
  }();
  return all;
}

double top_of(const std::vector<grain>& grains) {
  double top = 0;
  for (const grain& g : grains) top = std::max(top, g.position.z + g.radius);
  return top;
}

/// The packing between a floor and side walls, with a lid coming down at `lid_speed`.
template <class Friction>
auto pressed(const Friction& law, double dt, double lid_speed) {
  using boundary::constant_velocity;
  using boundary::plane;
  using boundary::wall;
  pendular::system s{
      material{normal::linear{1e3}, damping::viscous{0.6}, law},
      boundary::walls{wall{plane{{0, 0, 0}, {1, 0, 0}}}, wall{plane{{side, 0, 0}, {-1, 0, 0}}},
                      wall{plane{{0, 0, 0}, {0, 1, 0}}}, wall{plane{{0, side, 0}, {0, -1, 0}}},
                      wall{plane{{0, 0, 0}, {0, 0, 1}}},
                      wall{plane{{0, 0, top_of(settled())}, {0, 0, -1}}, constant_velocity{{0, 0, -lid_speed}}}},
      velocity_verlet{dt, gravity_down}, run_options{.force = true}};
  for (const grain& g : settled()) s.add(g);
  return s;
}

/// Mean stress of the lid over the last half of a fast compression by `speed` for `duration`, Pa.
template <class Friction>
double lid_stress(const Friction& law, double dt, double speed, double duration) {
  auto s = pressed(law, dt, speed);
  const auto steps = std::llround(duration / dt);
  double mean = 0;
  s.run(steps / 2);
  const std::int64_t samples = steps - steps / 2;
  for (std::int64_t n = 0; n < samples; ++n) {
    s.run(1);
    mean += boundary::get<5>(s.walls()).force.z / static_cast<double>(samples);
  }
  return mean / (side * side);
}

}  // namespace

TEST_CASE("a dense packing with viscous friction never gains kinetic energy, whatever gamma_t and time step") {
  for (const double gamma : {1.0, 1e3}) {
    for (const double dt : {1e-6, 5e-6}) {
      auto s = pressed(friction::viscous_coulomb{gamma, 0.4}, dt, 0);
      auto undisturbed = s;  // loose grains fall in it too, each as far as it happens to have room
      random_numbers random(5);
      s.start();
      for (const std::size_t row : s.particles().rows_by_id()) {
        s.particles().template get<column::velocity>()[row] = 1e-3 * random.in_cube();
        s.particles().template get<column::angular_velocity>()[row] = 2.0 * random.in_cube();
      }
      const double pushed = kinetic_energy(s);
      s.run(std::llround(1e-3 / dt));
      const double early = kinetic_energy(s);
      s.run(std::llround(4e-3 / dt));
      undisturbed.run(std::llround(5e-3 / dt));
      const double late = kinetic_energy(s) - kinetic_energy(undisturbed);
      CAPTURE(gamma, dt, early / pushed, late / pushed, kinetic_energy(undisturbed) / pushed);
      CHECK(early < 0.3 * pushed);
      CHECK(late < 0.03 * pushed);
    }
  }
}

TEST_CASE("the published form is refused in that packing at the published step") {
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.6}, friction::viscous_coulomb_explicit{1, 0.4}},
                     floor_plane(), velocity_verlet{1e-6, gravity_down}};
  for (const grain& g : settled()) s.add(g);
  CHECK_THROWS_AS(s.start(), input_error);
  auto forced = pressed(friction::viscous_coulomb_explicit{1e3, 0.4}, 5e-6, 0);
  forced.run(1000);
  auto stable = pressed(friction::viscous_coulomb{1e3, 0.4}, 5e-6, 0);
  stable.run(1000);
  // Held by its Coulomb cap only: the spins rattle.
  const auto rattle = [](const auto& x) {
    double sum = 0;
    for (const vector& w : x.particles().template get<column::angular_velocity>()) sum += dot(w, w);
    return sum;
  };
  CHECK(rattle(forced) > 10 * rattle(stable));
}

TEST_CASE("in a compressed packing the stable form goes to the published one as the step goes to 0", "[slow]") {
  const double speed = 0.02, duration = 1e-3;  // 20 um, creep and slip side by side
  const double truth = lid_stress(friction::viscous_coulomb_explicit{1, 0.4}, 1.5e-8, speed, duration);
  const double half = lid_stress(friction::viscous_coulomb_explicit{1, 0.4}, 3e-8, speed, duration);
  const double frictionless = lid_stress(friction::viscous_coulomb{1, 0.0}, 1e-6, speed, duration);
  auto reference = pressed(friction::viscous_coulomb_explicit{1, 0.4}, 1.5e-8, speed);
  reference.start();
  for (const scene_limit& l : reference.limits()) {
    if (l.what.find("viscosity") != std::string::npos) CHECK(l.holds());
  }
  std::array<double, 4> error{};
  const std::array<double, 4> steps{5e-6, 2e-6, 5e-7, 1e-7};
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double found = lid_stress(friction::viscous_coulomb{1, 0.4}, steps[k], speed, duration);
    error[k] = std::abs(found / truth - 1);
  }
  CAPTURE(truth, half, frictionless, error);
  CHECK(half == within(1e-3, truth));
  CHECK(std::abs(frictionless / truth - 1) > 0.1);  // friction decides
  CHECK(error[0] < 0.2);
  CHECK(error[1] < 0.05);
  CHECK(error[2] < 0.02);
  CHECK(error[3] < 0.005);
  CHECK(error[3] < error[1]);
}
