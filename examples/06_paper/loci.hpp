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

/// States of samples that differ by load and seed. A line is fitted to each seed: points of one packing are not independent.
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

/// Takes the seeds that have a run at every load. Errors: input_error for fewer than two loads, std::runtime_error if no
/// seed has them all.
locus locus_of(const std::vector<seeds>& loads, const state_function& state = residual_state);

/// By how much liquid changes the angle, seed by seed, degrees.
measured added_angle(const locus& wet, const locus& dry);
/// What a wet sample bears beyond the line of the dry one of the same seed at the same normal stress, mean of all loads,
/// for every seed, Pa. If the angles are the same it is by how much the intercepts differ, with a smaller error.
std::vector<double> beyond_dry_line(const locus& wet, const locus& dry);

}  // namespace paper
