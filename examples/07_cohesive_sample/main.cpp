// SPDX-License-Identifier: BSD-3-Clause
// The forces inside of a wet sample that nothing but its bridges holds together: Richefeu et al. 2006, sections 3 to 6.
#include "options.hpp"
#include "run.hpp"

int main(int count, char** arguments) {
  const options o = read_options(count, arguments);
  return examples::run_job("07_cohesive_sample", o, o.physics(), [&](const auto& from, const auto& watch) {
    o.friction == "coulomb-spring" ? run_with_coulomb_spring(o, from, watch) : run_with_viscous_coulomb(o, from, watch);
  });
}
