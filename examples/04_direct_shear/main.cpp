// SPDX-License-Identifier: BSD-3-Clause
// Direct shear of a dry or wet sample in a cylindrical cell: the paper's section 3.2 from deposition to the shear curve.
#include "options.hpp"
#include "run.hpp"

namespace {
void run(const options& o, const examples::restart& from, const pendular::scene::monitor& watch) {
  if (o.dry()) return run_dry(o, from, watch);
  if (o.law == "willett") return run_with_willett(o, from, watch);
  if (o.law == "laplace-young") return run_with_laplace_young(o, from, watch);
  if (o.law == "richefeu-harmonic") return run_with_richefeu_harmonic(o, from, watch);
  if (o.friction == "viscous-coulomb") return run_with_viscous_coulomb(o, from, watch);
  if (o.friction == "viscous-coulomb-explicit") return run_with_viscous_coulomb_explicit(o, from, watch);
  run_with_coulomb_spring(o, from, watch);
}
}  // namespace

int main(int count, char** arguments) {
  const options o = read_options(count, arguments);
  return examples::run_job("04_direct_shear", o, o.physics(),
                           [&](const auto& from, const auto& watch) { run(o, from, watch); });
}
