// SPDX-License-Identifier: BSD-3-Clause
// Integrators keep their promises, and the kit finds one that does not.
#include "../found.hpp"

#include <pendular/testing/integrator.hpp>
#include <pendular/testing/role_archetypes.hpp>

using namespace pendular;
using testing::integrator_report;

namespace {
template <class I>
constexpr auto make = [](double time_step, const vector& gravity) {
  return I{time_step, gravity};
};

/// Velocity Verlet with one mistake.
struct bad_integrator {
  enum class mistake {
    none,
    half_acceleration,  // in the way
    forgets_the_old,    // acceleration in the second half
    leaps_too_far,      // says that it is stable at steps that it is not
    no_time,            // a limit of another unit
    says_it_lags,
    spins_late,
    own_step,
    own_gravity
  };
};
template <auto Made>
struct verlet {
  using enum bad_integrator::mistake;
  static constexpr double velocity_lag = Made == says_it_lags ? 0.5 : 0;
  double time_step;
  vector gravity;
  verlet(double step, const vector& g)
      : time_step(Made == own_step ? 1e-5 : step), gravity(Made == own_gravity ? vector{0, 0, -9.8} : g) {}

  void predict(vector& x, vector& v, const vector& a) const {
    x += time_step * v + ((Made == half_acceleration ? 0.25 : 0.5) * time_step * time_step) * a;
    v += time_step * a;
  }
  void predict_spin(vector& spin, const vector& a) const { spin += (Made == spins_late ? 0.5 : 1) * time_step * a; }
  void correct(vector& v, const vector& before, const vector& now) const {
    v += (0.5 * time_step) * (now - before);
    if (Made == forgets_the_old) v += (0.1 * time_step) * now;
  }
  static double stable_step(double omega2, double rate) {
    const double step = velocity_verlet::stable_step(omega2, rate);
    if (Made == no_time) return 2 / (omega2 * (1 + rate));
    return Made == leaps_too_far ? 1.5 * step : step;
  }
};
template <auto Made>
auto report_of() {
  return integrator_report(make<verlet<Made>>);
}

/// Right in vectors, wrong in rows.
struct wrong_in_rows : velocity_verlet {
  template <class V>
  void predict(V& position, V& velocity, const V& acceleration) const {
    velocity_verlet::predict(position, velocity, acceleration);
    if constexpr (!std::is_same_v<V, vector>) position += time_step * velocity;
  }
};
}  // namespace

TEST_CASE("shipped integrators and the archetype keep their promises") {
  check_sound(integrator_report(make<velocity_verlet>));
  check_sound(integrator_report(make<half_step_velocity_verlet>));
  check_sound(
      integrator_report([](double step, const vector& g) { return testing::archetype::integrator(step, g); }, 1));
}

TEST_CASE("the integrator kit finds a broken promise") {
  using enum bad_integrator::mistake;
  check_sound(report_of<none>());
  CHECK(finds(report_of<half_acceleration>(), "the way of free fall must be exact"));
  CHECK(finds(report_of<half_acceleration>(), "the error of an oscillator must fall"));
  CHECK(finds(report_of<forgets_the_old>(), "the speed of free fall must be exact"));
  CHECK(finds(report_of<leaps_too_far>(), "an oscillator must stay bounded"));
  CHECK(finds(report_of<no_time>(), "the stable step must be a time"));
  CHECK(finds(report_of<says_it_lags>(), "the velocities that forces see"));
  CHECK(finds(report_of<spins_late>(), "spins must be predicted"));
  CHECK(finds(report_of<own_step>(), "the integrator must have the time step"));
  CHECK(finds(report_of<own_gravity>(), "the integrator must have the time step"));
  CHECK(finds(integrator_report([](double step, const vector& g) {
                return wrong_in_rows{{step, g}};
              }),
              "rows must move as vectors do"));
  // symplectic Euler is of first order
  CHECK(finds(integrator_report([](double step, const vector& g) { return testing::archetype::integrator(step, g); }),
              "the error of an oscillator must fall"));
}
