// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "curves.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <pendular/observe/coulomb_fit.hpp>

#include <functional>
#include <string>
#include <vector>

namespace paper {

/// The Coulomb line of one packing, and the means over its runs.
struct seed_line {
  std::string seed;
  pendular::observe::coulomb_line line;
  shear_state mean;

  double angle() const;  // degrees
};

/// States of samples that differ by load and seed, over the normal stress on the plane between the halves: what the lid
/// presses, and the weight of what lies above (the paper's sigma, section 3.1.1). A line is fitted to each seed: points of
/// one packing are not independent.
struct locus {
  std::vector<double> normal, shear;  // of every run, Pa
  std::vector<seed_line> lines;

  measured cohesion() const;  // intercept, Pa
  measured tan_friction() const;
  measured angle() const;    // degrees
  measured bridges() const;  // per grain
  measured height() const;   // of the lid, m
};

using state_function = std::function<shear_state(const run&)>;

/// Takes the seeds that have a run at every load. Errors: input_error for fewer than two loads.
locus locus_of(const std::vector<seeds>& loads, const state_function& state = residual_state);

/// By how much liquid changes the angle, seed by seed, degrees.
measured added_angle(const locus& wet, const locus& dry);
/// What a wet sample bears beyond the line of the dry one of the same seed at the same normal stress, mean of all loads,
/// for every seed, Pa: its cohesion if the angles are the same, with a smaller error than the intercept's.
std::vector<double> cohesions_at_dry_angle(const locus& wet, const locus& dry);

}  // namespace paper
