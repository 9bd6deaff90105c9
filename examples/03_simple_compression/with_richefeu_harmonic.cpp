// SPDX-License-Identifier: BSD-3-Clause
#include "test.hpp"

#include <pendular/law/capillary/richefeu_harmonic.hpp>
#include <pendular/law/rupture/lian.hpp>

void run_with_richefeu_harmonic(const options& o, const examples::restart& from,
                                const pendular::scene::monitor& watch) {
  using namespace pendular;
  test::with_usual_protocol(o, examples::spring_friction(o), capillary::richefeu_harmonic{}, rupture::lian{}, from,
                            watch);
}
