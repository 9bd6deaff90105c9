// SPDX-License-Identifier: BSD-3-Clause
#include "loci.hpp"

#include <pendular/observe/coulomb_fit.hpp>

#include <numbers>

namespace paper {

namespace {

using pendular::observe::coulomb_line;

/// The runs of one packing at all normal stresses.
seeds runs_with(const std::string& seed, const std::vector<seeds>& normal_stresses) {
  seeds found;
  for (const seeds& s : normal_stresses) {
    for (const run& r : s) {
      if (r.option("seed") == seed) found.push_back(r);
    }
  }
  return found;
}

mean_line mean_of_lines(const std::vector<coulomb_line>& lines) {
  std::vector<double> cohesion, tangent, angle;
  for (const coulomb_line& l : lines) {
    cohesion.push_back(l.cohesion);
    tangent.push_back(l.tan_friction);
    angle.push_back(180 / std::numbers::pi * l.friction_angle());
  }
  return {mean_of(cohesion), mean_of(tangent), mean_of(angle)};
}

}  // namespace

locus locus_of(const std::vector<seeds>& normal_stresses, const std::string& strength) {
  locus l;
  std::vector<coulomb_line> over_lid, over_plane;
  std::vector<double> bridges;
  for (const run& of_seed : normal_stresses.front()) {
    std::vector<double> lid, plane, shear;
    for (const run& r : runs_with(of_seed.option("seed"), normal_stresses)) {
      lid.push_back(r.number("strength", "normal_stress_Pa"));
      plane.push_back(r.number("strength", "plane_stress_Pa"));
      shear.push_back(r.number("strength", strength));
      bridges.push_back(r.number("sample", "bridges_per_grain_start"));
    }
    if (lid.size() < normal_stresses.size()) continue;
    over_lid.push_back(pendular::observe::coulomb_fit(lid, shear));
    over_plane.push_back(pendular::observe::coulomb_fit(plane, shear));
    l.plane.insert(l.plane.end(), plane.begin(), plane.end());
    l.shear.insert(l.shear.end(), shear.begin(), shear.end());
  }
  l.over_lid = mean_of_lines(over_lid);
  l.over_plane = mean_of_lines(over_plane);
  l.bridges = mean_of(bridges);
  return l;
}

}  // namespace paper
