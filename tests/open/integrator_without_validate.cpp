// SPDX-License-Identifier: BSD-3-Clause
// A user's integrator, written from outside, with nothing but what the concept asks for: symplectic Euler.
#include "../catch.hpp"

#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <numbers>

using namespace pendular;

namespace {

struct symplectic_euler {
  static constexpr double velocity_lag = 0;
  double time_step;
  vector gravity{0, 0, 0};

  void predict(vector& position, vector& velocity, const vector& acceleration) const {
    velocity += time_step * acceleration;
    position += time_step * velocity;
  }
  void predict_spin(vector& spin, const vector& acceleration) const { spin += time_step * acceleration; }
  void correct(vector&, const vector&, const vector&) const {}
  static double stable_step(double omega2, double rate) { return 2 / (std::sqrt(omega2 + rate * rate) + rate); }
};
static_assert(Integrator<symplectic_euler>);

}  // namespace

TEST_CASE("a scene runs under an integrator without validate: an elastic impact returns its speed") {
  const double stiffness = 1e3, speed = 0.1, radius = 0.5e-3;
  pendular::system s{material{normal::linear{stiffness}}, boundary::walls{}, symplectic_euler{1e-7}};
  s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600, .velocity = {speed, 0, 0}});
  s.add({.position = {2.001 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {-speed, 0, 0}});
  s.run(2000);
  CHECK(s.particles()[s.particles().rows_by_id()[0]].velocity.x == within(1e-3, -speed));
  CHECK(s.particles()[s.particles().rows_by_id()[1]].velocity.x == within(1e-3, speed));
}
