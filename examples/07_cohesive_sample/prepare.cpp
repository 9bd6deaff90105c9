// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include <pendular/law/friction/coulomb_spring.hpp>

namespace {

using namespace pendular;

template <class Material>
scene::boxed_packing packed(const options& o, const Material& grains, const examples::restart& from,
                            const scene::monitor& watch) {
  const material walls{normal::linear{o.stiffness}, damping::viscous{0.8}, energy_book{}};
  scene::box_packing<Material> packing(o.preparation(), grains, walls);
  if (from) packing.resume(*from);
  const scene::boxed_packing done = packing.run(watch);
  scene::write(done, o.output / "packing.bin");
  return done;
}

}  // namespace

scene::boxed_packing prepare(const options& o, const examples::restart& from, const scene::monitor& watch) {
  if (!o.packing.empty()) return scene::load_boxed_packing(io::checkpoint_reader(o.packing), o.preparation());
  const normal::linear elastic{o.stiffness};
  const damping::viscous dashpot{0.8};
  if (o.preparation_friction == 0) return packed(o, material{elastic, dashpot}, from, watch);
  const friction::coulomb_spring friction{0.8 * o.stiffness, o.preparation_friction};
  return packed(o, material{elastic, dashpot, friction}, from, watch);
}
