// SPDX-License-Identifier: BSD-3-Clause
// The programs of docs/reference/laplace_young.md.
#include <pendular/laplace_young/law.hpp>
#include <pendular/pendular.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace pendular;

int main() {
  // [solver]
  const laplace_young::liquid_bridge between{.radius_i = 1e-3, .radius_j = 2e-3, .contact_angle = 0.35,
                                             .volume = 1e-11, .surface_tension = 0.048};
  laplace_young::bridges_of_volume all(between);
  for (double gap = 0; gap < 0.5e-3; gap += 0.05e-3) {
    if (const auto s = all.at(gap)) std::printf("%.2f mm: %.3e N at %.0f Pa\n", 1e3 * gap, s->attraction, s->suction);
  }
  // [/solver]
  // [laplace_young]
  const fluid wine{.surface_tension = 0.048, .contact_angle = 0.35, .density = 985, .viscosity = 1.6e-3};
  const liquid exact{wine, capillary::laplace_young(wine), rupture::laplace_young(wine), protocol::homogeneous{5000}};
  // [/laplace_young]
  const bridge<double> b{1e-4, 1e-11, 1e-3, 2e-3};
  const double from_table = exact.law().attraction(b, wine), solved = all.at(1e-4)->attraction;
  const double end = exact.rupture_distance(b), solved_end = all.rupture_distance();
  std::printf("table %.6e N, solver %.6e N; rupture %.6e m, %.6e m\n", from_table, solved, end, solved_end);
  const bool near = std::abs(from_table / solved - 1) < 1e-3 && std::abs(end / solved_end - 1) < 1e-6;
  return near ? EXIT_SUCCESS : EXIT_FAILURE;
}
