// SPDX-License-Identifier: BSD-3-Clause
// expect 1: an integrator must be copyable
// expect 2: an integrator needs the members `double time_step` and `vector gravity`
// expect 3: an integrator needs `void predict(vector& position, vector& velocity, const vector& acceleration) const`
// expect 4: an integrator needs `void correct(vector& velocity, const vector& before, const vector& now) const`
// expect 5: an integrator needs `static double stable_step(double omega2, double rate)`
// expect 6: an integrator needs `static constexpr double velocity_lag`
// expect 7: and `void predict_spin(vector& spin, const vector& acceleration) const`
#include <pendular/motion/check.hpp>

#include <memory>

using namespace pendular;

struct symplectic_euler {
#if PENDULAR_MISTAKE != 6
  static constexpr double velocity_lag = 0;
#endif
  double time_step;
#if PENDULAR_MISTAKE != 2
  vector gravity{0, 0, 0};
#endif
#if PENDULAR_MISTAKE == 1
  std::unique_ptr<double> scratch = nullptr;
#endif

#if PENDULAR_MISTAKE == 3
  void predict(vector& position, const vector& velocity) const { position += time_step * velocity; }
#else
  void predict(vector& position, vector& velocity, const vector& acceleration) const {
    velocity += time_step * acceleration;
    position += time_step * velocity;
  }
#endif
#if PENDULAR_MISTAKE != 7
  void predict_spin(vector& spin, const vector& acceleration) const { spin += time_step * acceleration; }
#endif
#if PENDULAR_MISTAKE == 4
  void correct(vector&, const vector&, const vector&) {}
#else
  void correct(vector&, const vector&, const vector&) const {}
#endif
#if PENDULAR_MISTAKE == 5
  double stable_step(double omega2, double) const { return 2 / omega2; }
#else
  static double stable_step(double omega2, double rate) { return 2 / (omega2 + rate); }
#endif
};

static_assert(check::integrator<symplectic_euler>);
