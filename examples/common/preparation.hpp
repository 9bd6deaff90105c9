// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job.hpp"

#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/scene/packing.hpp>

namespace examples {

/// Makes a packing with grains of this material, or goes on doing so, and keeps it beside the results.
template <class Material>
pendular::scene::sealed_packing packed(const job_options& o, const pendular::scene::packing_parameters& p,
                                       const Material& grains, double stiffness, const restart& from,
                                       const pendular::scene::monitor& watch) {
  using namespace pendular;
  scene::packing<Material> packing(p, grains, material{normal::linear{stiffness}, damping::viscous{0.8}});
  if (from) packing.resume(*from);
  const scene::sealed_packing done = packing.run(watch);
  scene::write(done, o.output / "packing.bin");
  return done;
}

/// The packing of a test: the one that the options name, or one that is made with their stiffness and with their friction
/// between grains while they fall and are sealed.
template <class Options>
pendular::scene::sealed_packing packing_of(const Options& o, const pendular::scene::packing_parameters& p,
                                           const restart& from, const pendular::scene::monitor& watch) {
  using namespace pendular;
  if (!o.packing.empty()) return scene::load_packing(io::checkpoint_reader(o.packing), p);
  const normal::linear elastic{o.stiffness};
  const damping::viscous dashpot{0.8};
  if (o.preparation_friction == 0) return packed(o, p, material{elastic, dashpot}, o.stiffness, from, watch);
  const friction::coulomb_spring friction{0.8 * o.stiffness, o.preparation_friction};
  return packed(o, p, material{elastic, dashpot, friction}, o.stiffness, from, watch);
}

}  // namespace examples
