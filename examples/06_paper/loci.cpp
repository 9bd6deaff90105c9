// SPDX-License-Identifier: BSD-3-Clause
#include "loci.hpp"

#include <numbers>
#include <stdexcept>

namespace paper {

namespace {

/// The runs of one packing under all loads.
seeds runs_with(const std::string& seed, const std::vector<seeds>& loads) {
  seeds found;
  for (const seeds& s : loads) {
    for (const run& r : s) {
      if (r.option("seed") == seed) found.push_back(r);
    }
  }
  return found;
}

shear_state mean_state(const std::vector<shear_state>& states) {
  shear_state mean{0, 0, 0, 0, 0};
  for (const shear_state& s : states) {
    for (const auto member : {&shear_state::shear, &shear_state::normal, &shear_state::bridges, &shear_state::height,
                              &shear_state::shared}) {
      mean.*member += s.*member / static_cast<double>(states.size());
    }
  }
  return mean;
}

template <class Value>
measured mean_of_lines(const locus& l, const Value& value) {
  std::vector<double> values;
  for (const seed_line& line : l.lines) values.push_back(value(line));
  return mean_of(values);
}

template <class Value>
std::vector<double> by_seed(const locus& wet, const locus& dry, const Value& value) {
  std::vector<double> values;
  for (const seed_line& w : wet.lines) {
    for (const seed_line& d : dry.lines) {
      if (w.seed == d.seed) values.push_back(value(w, d));
    }
  }
  return values;
}

}  // namespace

double seed_line::angle() const { return 180 / std::numbers::pi * line.friction_angle(); }

measured locus::cohesion() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.line.cohesion; });
}
measured locus::tan_friction() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.line.tan_friction; });
}
measured locus::angle() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.angle(); });
}
measured locus::bridges() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.mean.bridges; });
}
measured locus::height() const {
  return mean_of_lines(*this, [](const seed_line& l) { return l.mean.height; });
}

locus locus_of(const std::vector<seeds>& loads, const state_function& state) {
  locus l;
  for (const run& first : loads.front()) {
    const std::string seed = first.option("seed");
    const seeds of_one_packing = runs_with(seed, loads);
    if (of_one_packing.size() < loads.size()) continue;
    std::vector<shear_state> states;
    std::vector<double> normal, shear;
    for (const run& r : of_one_packing) {
      states.push_back(state(r));
      normal.push_back(states.back().normal), shear.push_back(states.back().shear);
    }
    l.lines.push_back({seed, pendular::observe::coulomb_fit(normal, shear), mean_state(states)});
    l.normal.insert(l.normal.end(), normal.begin(), normal.end());
    l.shear.insert(l.shear.end(), shear.begin(), shear.end());
  }
  if (l.lines.empty())
    throw std::runtime_error("no seed has a run at every load: " + loads.front().front().folder().string());
  return l;
}

measured added_angle(const locus& wet, const locus& dry) {
  return mean_of(by_seed(wet, dry, [](const seed_line& w, const seed_line& d) { return w.angle() - d.angle(); }));
}

std::vector<double> beyond_dry_line(const locus& wet, const locus& dry) {
  return by_seed(wet, dry, [](const seed_line& w, const seed_line& d) {
    return w.mean.shear - d.line.cohesion - d.line.tan_friction * w.mean.normal;
  });
}

}  // namespace paper
