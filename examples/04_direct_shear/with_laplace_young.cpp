// SPDX-License-Identifier: BSD-3-Clause
#include "test.hpp"

#include <pendular/laplace_young/law.hpp>

void run_with_laplace_young(const options& o, const examples::restart& from, const pendular::scene::monitor& watch) {
  using namespace pendular;
  test::with_usual_protocol(o, examples::spring_friction(o), capillary::laplace_young(examples::water(o)),
                            rupture::laplace_young(examples::water(o)), from, watch);
}
