// SPDX-License-Identifier: BSD-3-Clause
#include "test.hpp"

void run_dry(const options& o, const examples::restart& from, const pendular::scene::monitor& watch) {
  using namespace pendular;
  if (o.friction == "viscous-coulomb") return test::run(o, examples::viscous_friction(o), dry{}, from, watch);
  if (o.friction == "viscous-coulomb-explicit") {
    return test::run(o, examples::explicit_viscous_friction(o), dry{}, from, watch);
  }
  test::run(o, examples::spring_friction(o), dry{}, from, watch);
}
