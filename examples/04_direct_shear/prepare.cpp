// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include "../common/preparation.hpp"

namespace {
pendular::scene::packing_parameters parameters(const options& o) {
  pendular::scene::packing_parameters p;
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

pendular::scene::sealed_packing prepare(const options& o, const examples::restart& from,
                                        const pendular::scene::monitor& watch) {
  return examples::packing_of(o, parameters(o), from, watch);
}
