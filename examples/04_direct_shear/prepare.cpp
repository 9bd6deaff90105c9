// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

using namespace pendular;

namespace {
scene::packing_parameters parameters(const options& o) {
  scene::packing_parameters p;
  p.grains = o.grains;
  p.sizes = o.grain_sizes();
  p.cylinder_radius = o.cell_radius();
  p.deposition = 0.3;
  p.sealing = 0;                            // the lid comes when the liquid is there
  p.time_step = o.preparation_time_step();  // grains weigh what they weigh while the sample is made
  p.seed = o.seed;
  p.numerics.force = o.force;
  return p;
}
}  // namespace

scene::sealed_packing prepare(const options& o, const examples::restart& from, const scene::monitor& watch) {
  if (!o.packing.empty()) return scene::load_packing(io::checkpoint_reader(o.packing), parameters(o));
  const material smooth{normal::linear{o.stiffness}, damping::viscous{0.8}};
  scene::packing packing(parameters(o), smooth, smooth);
  if (from) packing.resume(*from);
  const scene::sealed_packing deposited = packing.run(watch);
  scene::write(deposited, o.output / "packing.bin");
  return deposited;
}
