// SPDX-License-Identifier: BSD-3-Clause
// The second program of docs/reference/scenes.md, with far fewer and shorter stages than a real test.
#include <pendular/pendular.hpp>

#include <cstdio>
#include <cstdlib>

using namespace pendular;

int main() {
  // [shear]
  const material glass{normal::linear{2500}, damping::viscous{0.8}};
  scene::packing_parameters sample;
  sample.grains = 60;
  sample.sizes = scene::shear_grading();
  sample.cylinder_radius = 4.5e-3;
  sample.deposition = 0.05;
  sample.time_step = 4e-6;
  sample.sealing = 0;  // the lid comes when the liquid is there
  const scene::sealed_packing deposited = scene::packing(sample, glass, glass).run({});

  const auto with_friction = [](double coefficient) {
    return material{normal::linear{2500}, damping::viscous{0.8}, friction::coulomb_spring{2000, coefficient},
                    energy_book{}};
  };
  // before friction comes; between grains; of the two halves; of floor and lid
  const scene::shear_materials materials{with_friction(0), with_friction(0.4), with_friction(0), with_friction(0.4)};
  scene::shear_parameters test;
  test.cell_radius = sample.cylinder_radius;
  test.time_step = 4e-6;
  test.consolidation = test.rest = 0.01;
  test.shear_speed = 10e-3;
  test.displacement = 2e-4;
  scene::direct_shear shear(test, materials, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}});
  shear.start(deposited);
  for (const scene::shear_record& line : shear.run({}).records) {
    std::printf("%.4e m  %.1f Pa under %.1f Pa\n", line.displacement, line.stress.shear, line.stress.plane);
  }
  // [/shear]
  const auto& records = shear.result().records;
  return records.size() == 20 && records.back().stress.shear > 20 && records.back().stress.lid > 200 ? EXIT_SUCCESS
                                                                                                     : EXIT_FAILURE;
}
