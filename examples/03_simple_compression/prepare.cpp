// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include <pendular/law/friction/coulomb_spring.hpp>

namespace {

using namespace pendular;

scene::packing_parameters parameters(const options& o) {
  scene::packing_parameters p;
  p.grains = o.grains;
  p.cylinder_radius = o.cylinder_radius();
  p.time_step = o.preparation_time_step();  // grains weigh what they weigh while the sample is made
  p.seed = o.seed;
  p.numerics.force = o.force;
  return p;
}

template <class Material>
scene::sealed_packing prepare_with(const options& o, const Material& m, const examples::restart& from,
                                   const scene::monitor& watch) {
  scene::packing<Material> packing(parameters(o), m, material{normal::linear{o.stiffness}, damping::viscous{0.8}});
  if (from) packing.resume(*from);
  const scene::sealed_packing sealed = packing.run(watch);
  scene::write(sealed, o.output / "packing.bin");
  return sealed;
}

}  // namespace

scene::sealed_packing prepare(const options& o, const examples::restart& from, const scene::monitor& watch) {
  if (!o.packing.empty()) return scene::load_packing(io::checkpoint_reader(o.packing), parameters(o));
  const normal::linear elastic{o.stiffness};
  const damping::viscous dashpot{0.8};
  if (o.preparation_friction > 0) {
    return prepare_with(o,
                        material{elastic, dashpot, friction::coulomb_spring{0.8 * o.stiffness, o.preparation_friction}},
                        from, watch);
  }
  return prepare_with(o, material{elastic, dashpot}, from, watch);
}
