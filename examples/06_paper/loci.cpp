// SPDX-License-Identifier: BSD-3-Clause
#include "loci.hpp"

#include <numbers>
#include <numeric>

namespace paper {

namespace {

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

seed_line line_of(const seeds& of_one_packing, const std::string& strength) {
  const auto values = [&](const std::string& name) {
    return each(of_one_packing, [&](const run& r) { return r.number("strength", name); });
  };
  const auto lid = values("normal_stress_Pa"), plane = values("plane_stress_Pa"), shear = values(strength);
  return {of_one_packing.front().option("seed"), pendular::observe::coulomb_fit(lid, shear),
          pendular::observe::coulomb_fit(plane, shear),
          std::accumulate(shear.begin(), shear.end(), 0.0) / static_cast<double>(shear.size())};
}

template <class Value>
measured mean_of_lines(const locus& l, const Value& value) {
  std::vector<double> values;
  for (const seed_line& line : l.lines) values.push_back(value(line));
  return mean_of(values);
}

template <class Value>
measured added(const locus& wet, const locus& dry, const Value& value) {
  std::vector<double> values;
  for (const seed_line& w : wet.lines) {
    for (const seed_line& d : dry.lines) {
      if (w.seed == d.seed) values.push_back(value(w) - value(d));
    }
  }
  return mean_of(values);
}

double degrees(const pendular::observe::coulomb_line& l) { return 180 / std::numbers::pi * l.friction_angle(); }

}  // namespace

measured locus::intercept() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.over_lid.cohesion; });
}
measured locus::tan_friction() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.over_lid.tan_friction; });
}
measured locus::lid_angle() const {
  return mean_of_lines(*this, [](const seed_line& l) { return degrees(l.over_lid); });
}
measured locus::plane_angle() const {
  return mean_of_lines(*this, [](const seed_line& l) { return degrees(l.over_plane); });
}

locus locus_of(const std::vector<seeds>& normal_stresses, const std::string& strength) {
  locus l;
  std::vector<double> bridges;
  for (const run& first : normal_stresses.front()) {
    const seeds of_one_packing = runs_with(first.option("seed"), normal_stresses);
    if (of_one_packing.size() < normal_stresses.size()) continue;
    l.lines.push_back(line_of(of_one_packing, strength));
    for (const run& r : of_one_packing) {
      l.lid.push_back(r.number("strength", "normal_stress_Pa"));
      l.shear.push_back(r.number("strength", strength));
      bridges.push_back(r.number("sample", "bridges_per_grain_start"));
    }
  }
  l.bridges = mean_of(bridges);
  return l;
}

measured added_intercept(const locus& wet, const locus& dry) {
  return added(wet, dry, [](const seed_line& l) { return l.over_lid.cohesion; });
}
measured added_shear_stress(const locus& wet, const locus& dry) {
  return added(wet, dry, [](const seed_line& l) { return l.mean_shear; });
}

}  // namespace paper
