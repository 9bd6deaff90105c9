// SPDX-License-Identifier: BSD-3-Clause
// Direct shear of a dry or wet sample in a cylindrical cell: the paper's section 3.2 from deposition to the shear curve.
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
  return examples::run_job("04_direct_shear", o, o.physics(), [&](const auto& from, const auto& watch) {
    o.dry() ? run_dry(o, from, watch) : compositions.at(o.composition())(o, from, watch);
  });
}
