// SPDX-License-Identifier: BSD-3-Clause
#include "loci.hpp"

#include <string>

namespace paper {

namespace {

locus fitted(const std::vector<seeds>& normal_stresses, const std::string& quantity) {
  locus l;
  std::vector<double> bridges;
  for (const seeds& s : normal_stresses) {
    for (const run& r : s) {
      l.lid.push_back(r.number("strength", "normal_stress_Pa"));
      l.plane.push_back(r.number("strength", "plane_stress_Pa"));
      l.shear.push_back(r.number("strength", quantity));
      bridges.push_back(r.number("sample", "bridges_per_grain_start"));
    }
  }
  l.over_lid = pendular::observe::coulomb_fit(l.lid, l.shear);
  l.over_plane = pendular::observe::coulomb_fit(l.plane, l.shear);
  l.bridges = mean_of(bridges);
  return l;
}

}  // namespace

locus locus_of(const std::vector<seeds>& s) { return fitted(s, "residual_shear_stress_Pa"); }
locus peak_locus_of(const std::vector<seeds>& s) { return fitted(s, "peak_shear_stress_Pa"); }

}  // namespace paper
