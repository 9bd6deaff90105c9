// SPDX-License-Identifier: BSD-3-Clause
#include "relax.hpp"

void run_with_viscous_coulomb(const options& o, const examples::restart& from, const pendular::scene::monitor& watch) {
  relax::with_friction(o, examples::viscous_friction(o), from, watch);
}
