// SPDX-License-Identifier: BSD-3-Clause
#include "test.hpp"

#include <pendular/law/capillary/willett.hpp>
#include <pendular/law/rupture/willett.hpp>

void run_with_willett(const options& o, const examples::restart& from, const pendular::scene::monitor& watch) {
  using namespace pendular;
  test::with_usual_protocol(o, examples::spring_friction(o), capillary::willett{}, rupture::willett{}, from, watch);
}
