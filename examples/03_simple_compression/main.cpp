// SPDX-License-Identifier: BSD-3-Clause
// Simple compression of a wet cylindrical sample: the paper's section 4 from deposition to the stress-strain curve.
#include "options.hpp"
#include "run.hpp"

#include <map>
#include <string>

namespace {
const std::map<std::string, decltype(&run_with_coulomb_spring)> compositions{
    {"coulomb-spring", run_with_coulomb_spring},
    {"viscous-coulomb", run_with_viscous_coulomb},
    {"viscous-coulomb-explicit", run_with_viscous_coulomb_explicit},
    {"richefeu-harmonic", run_with_richefeu_harmonic},
    {"willett", run_with_willett},
    {"laplace-young", run_with_laplace_young}};
}  // namespace

int main(int count, char** arguments) {
  const options o = read_options(count, arguments);
  return examples::run_job("03_simple_compression", o, o.physics(), [&](const auto& from, const auto& watch) {
    compositions.at(o.composition())(o, from, watch);
  });
}
