// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include <pendular/law/friction/coulomb_spring.hpp>

#include <cmath>

namespace {

using namespace pendular;

template <class Material>
scene::sealed_packing prepare_with(const options& o, const Material& m, const restart& from,
                                   const scene::monitor& watch) {
  scene::packing_parameters p;
  p.grains = o.grains;
  p.cylinder_radius *= std::cbrt(static_cast<double>(o.grains) / 8000.0);
  p.time_step = o.time_step / std::sqrt(o.mass_scaling);  // grains weigh what they weigh while the sample is made
  p.seed = o.seed;
  p.force = o.force;
  scene::packing<Material> packing(p, m, material{normal::linear{1e3}, damping::viscous{0.8}});
  if (from) packing.resume(*from);
  const scene::sealed_packing sealed = packing.run(watch);
  io::checkpoint_writer out(o.output / "packing.bin");
  scene::save(out, sealed);
  out.commit();
  return sealed;
}

scene::sealed_packing read_packing(const options& o) {
  const scene::sealed_packing packing = scene::load_packing(io::checkpoint_reader(o.packing));
  expects(static_cast<std::int64_t>(packing.grains.size()) == o.grains, "the number of grains in the packing",
          static_cast<double>(packing.grains.size()), "that of --grains", "docs/how-to/run_the_paper.md");
  return packing;
}

}  // namespace

scene::sealed_packing prepare(const options& o, const restart& from, const scene::monitor& watch) {
  if (!o.packing.empty()) return read_packing(o);
  const normal::linear elastic{1e3};
  const damping::viscous dashpot{0.8};
  if (o.preparation_friction > 0) {
    return prepare_with(o, material{elastic, dashpot, friction::coulomb_spring{800, o.preparation_friction}}, from,
                        watch);
  }
  return prepare_with(o, material{elastic, dashpot}, from, watch);
}
