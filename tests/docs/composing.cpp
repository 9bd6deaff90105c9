// SPDX-License-Identifier: BSD-3-Clause
// The programs of docs/reference, and of docs/explanation where it shows code.
#include <pendular/pendular.hpp>

#include <range/v3/numeric/accumulate.hpp>
#include <range/v3/view/filter.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace pendular;

// [material]
const material dry_glass{normal::hertz{7e10, 0.22}, damping::viscous{0.3}};
const material paper_grains{energy_book{}, friction::viscous_coulomb{1.0, 0.4}, normal::linear{1e3},
                            damping::viscous{0.8}};  // any order
// [/material]

// [liquid]
const liquid paper_liquid{fluid{.surface_tension = 0.0637, .contact_angle = 0, .density = 1000, .viscosity = 1e-3},
                          capillary::richefeu{}, rupture::lian{}, protocol::homogeneous{5000}};
const liquid films{fluid::water(), capillary::richefeu_harmonic{}, rupture::willett{}, protocol::grain_films{},
                   formation::at_contact{.minimum_volume = 1e-5}};
// [/liquid]

// [boundary]
auto cell(double cylinder_radius, double lid_height) {
  using namespace pendular::boundary;
  const material smooth{normal::linear{1e3}, damping::viscous{0.8}};  // walls without friction
  const double area = 3.14159 * cylinder_radius * cylinder_radius;
  return walls{wall{plane{{0, 0, 0}, {0, 0, 1}}},
               wall{cylinder{{0, 0, 0}, {0, 0, 1}, cylinder_radius}, fixed{}, smooth},
               wall{plane{{0, 0, lid_height}, {0, 0, -1}}, servo_stress{300, area, 2 * area, 2000 * area}, smooth}};
}
// [/boundary]

// [wet_wall]
const boundary::wall glass_plate{boundary::plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{},
                                 boundary::wettable{}};
const pendular::system drops{material{normal::linear{1e3}},
                             liquid{fluid::water(), capillary::bagheri{}, rupture::willett{}},  // laws that know planes
                             boundary::walls{glass_plate}, velocity_verlet{1e-6}};
// [/wet_wall]

int main() {
  // [system]
  pendular::system wet{paper_grains, paper_liquid, cell(5e-3, 3e-3), half_step_velocity_verlet{4e-6, {0, 0, -9.81}},
                       run_options{.skin = 0.3}};
  pendular::system dry{dry_glass, cell(5e-3, 3e-3), velocity_verlet{1e-8}};
  // [/system]
  // [grains]
  for (int k = 0; k < 16; ++k) {
    wet.add({.position = {1.1e-3 * (k % 4 - 1.5), 1.1e-3 * (k / 4 - 1.5), 0.5e-3}, .radius = 0.5e-3, .density = 2700});
  }
  // [/grains]
  // [run]
  wet.run(2000);
  wet.distribute_liquid(16 * 1e-12, {.thinning = 2, .seed = 7});
  wet.run(2000);
  // [/run]
  // [by_id]
  const auto rows = wet.particles().rows_by_id();
  const vector centre = wet.particles().get<column::position>()[rows[3]];  // of the grain that was added fourth
  // [/by_id]
  // [observe]
  const observe::coordination z = observe::coordination_of(wet);
  const observe::energies e = observe::energies_of(wet);
  const Eigen::Matrix3d stress = observe::love_weber_stress(wet, 3e-3 * 7.85e-5);
  const double unrest = observe::unbalanced_force_ratio(wet);
  // [/observe]
  // [pairs]
  auto hard = observe::pairs(wet) | ::ranges::views::filter(observe::touching) |
              ::ranges::views::transform(observe::push_of);  // N
  const double hardest = ::ranges::accumulate(hard, 0.0, [](double a, double b) { return std::max(a, b); });
  // [/pairs]
  // [network]
  const Eigen::Matrix3d fabric = observe::fabric_tensor(wet, observe::links::bridges);
  const observe::force_distribution forces = observe::force_distribution_of(wet);
  const std::vector<double> edges{0, 0.5, 1, 1.5, 2, 3, 4};  // of bins, in units of the mean
  const std::vector<double> density = observe::probability_density(forces.tensile, forces.mean_tensile, edges);
  const std::vector<double> pressures = observe::grain_pressures(wet, 0.6);
  // [/network]
  // [wall]
  const double push_of_lid = boundary::get<2>(wet.walls()).force.z;  // N, of the grains on the lid
  // [/wall]
  std::printf("z %g, bridges %g, energy %g J, stress %g Pa, unrest %g, lid %g N, z_3 %g m\n", z.contacts, z.bridges,
              e.balance(), stress(2, 2), unrest, push_of_lid, centre.z);
  dry.add({.position = {0, 0, 0.5e-3}, .radius = 0.5e-3, .density = 2500});
  dry.run(10);
  const bool sound = std::isfinite(e.balance()) && hardest >= 0 && std::isfinite(unrest) &&
                     std::abs(centre.z - 0.5e-3) < 1e-5 && std::abs(wet.bridges().book().total() - 16e-12) < 1e-24 &&
                     fabric.allFinite() && density.size() == edges.size() - 1 && pressures.size() == 16;
  return sound ? EXIT_SUCCESS : EXIT_FAILURE;
}
