// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/reference/scenes.md, with far fewer and shorter stages than a real test.
#include <pendular/pendular.hpp>

#include <cstdio>
#include <cstdlib>

using namespace pendular;

int main() {
  // [scene]
  const material walls{normal::linear{1e3}, damping::viscous{0.8}};
  scene::packing_parameters sample;
  sample.grains = 60;
  sample.cylinder_radius = 2.5e-3;
  sample.deposition = sample.sealing = 0.02;
  scene::packing packing(sample, walls, walls);  // grains without friction make the densest sample
  const scene::sealed_packing sealed = packing.run({});

  const material grains{normal::linear{1e3}, damping::viscous{0.8}, friction::coulomb_spring{800, 0.4}, energy_book{}};
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::homogeneous{1250}};
  scene::compression_parameters test{.area = sample.area()};
  test.relaxation = 0.01;
  test.lid_speed = 5e-3;
  test.duration = 0.01;
  scene::simple_compression compression(test, grains, water);
  compression.start(sealed);
  const scene::compression_result& result = compression.run({});
  for (const scene::compression_record& line : result.records) {
    std::printf("%.4e m  %.1f Pa\n", line.shortening, line.stress);
  }
  // [/scene]
  return result.records.size() == 10 && result.records.back().shortening > 4e-5 &&
                 result.records.back().stress > 10
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
