// SPDX-License-Identifier: BSD-3-Clause

// Prints the tables of docs/explanation/integrators.md: test_physics "[.report]"
#include "between_spheres.hpp"
#include "integrator_energy.hpp"

#include <cstdio>

namespace {

using pendular::half_step_velocity_verlet;
using pendular::velocity_verlet;

constexpr std::array<double, 4> resolutions{25, 50, 100, 200};

/// One line: `error` is called with the type of the integrator and the steps per contact.
template <class Error>
void line(const char* what, const Error& error) {
  const auto put = [](double x) { std::printf(" %.1e |", x); };
  std::printf("| %s |", what);
  for (const double n : resolutions) put(error.template operator()<velocity_verlet>(n));
  for (const double n : resolutions) put(error.template operator()<half_step_velocity_verlet>(n));
  std::printf("\n");
  std::fflush(stdout);
}

void impacts() {
  using namespace integrator_scenes;
  const auto sliding = [](const char* what, const impact& c) {
    line(what, [&]<class I>(double n) { return sliding_impact<I>(c, n).friction; });
  };
  const auto bounce = [](const char* what, const impact& c) {
    line(what, [&]<class I>(double n) { return sliding_impact<I>(c, n).normal; });
  };
  bounce("4, restitution", chung_4(60));
  sliding("4, sliding", chung_4(60));
  sliding("5, sliding", chung_5(4));
  bounce("6, restitution", chung_6(6));
  sliding("6, sliding", chung_6(6));
  sliding("7, equal spins", chung_7(5, 1));
  sliding("7, opposite spins", chung_7(5, -1));
  sliding("8, sliding", chung_8(5));
  line("sticking", []<class I>(double n) { return sticking_impact<I>(n); });
  line("incline, rolling", []<class I>(double n) { return incline<I>(20, n); });
  line("incline, sliding", []<class I>(double n) { return incline<I>(45, n); });
  line("incline, creep", []<class I>(double n) { return creep<I>(1, n); });
}

/// Degrees too late at which a sphere falls off, and in brackets the largest push on it over its weight.
template <class Law>
void falls(const Law& law) {
  using namespace between_spheres;
  const auto put = [](const fall& f, double exact) {
    std::isinf(f.angle) ? std::printf(" never (%.3g) |", f.held_force)
                        : std::printf(" %.2f (%.2g) |", f.angle - exact, f.held_force);
    std::fflush(stdout);
  };
  for (const double ratio : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    const wedge w{ratio, law.friction_coefficient};
    const double exact = rigid_fall(w);
    std::printf("| %g | %.2f | %.2f |", ratio, w.ring() / w.held(), exact);
    for (const double n : resolutions) put(fallen<velocity_verlet>(w, n, law), exact);
    for (const double n : resolutions) put(fallen<half_step_velocity_verlet>(w, n, law), exact);
    std::printf("\n");
  }
}

void energies() {
  using namespace integrator_energy;
  line("elastic pair, first tenth", []<class I>(double n) { return elastic_pair<I>(n, 2000).early; });
  line("elastic pair, last tenth", []<class I>(double n) { return elastic_pair<I>(n, 2000).late; });
  line("sheared packing", []<class I>(double n) { return sheared_packings<I>(n, 4).imbalance; });
  line("time of a step, s", []<class I>(double n) { return sheared_packings<I>(n, 4).step_time; });
}

}  // namespace

TEST_CASE("report: integrators", "[.report]") {
  impacts();
  energies();
  falls(pendular::friction::coulomb_spring{8235, 0.5});
  falls(pendular::friction::viscous_coulomb{1, 0.5});
}
