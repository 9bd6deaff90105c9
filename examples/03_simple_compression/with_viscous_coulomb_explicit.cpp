// SPDX-License-Identifier: BSD-3-Clause
#include "test.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/rupture/lian.hpp>

void run_with_viscous_coulomb_explicit(const options& o, const examples::restart& from,
                                       const pendular::scene::monitor& watch) {
  using namespace pendular;
  test::with_usual_protocol(o, examples::explicit_viscous_friction(o), capillary::richefeu{}, rupture::lian{}, from,
                            watch);
}
