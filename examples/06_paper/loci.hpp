// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measured.hpp"
#include "run.hpp"

#include <pendular/observe/coulomb_fit.hpp>

#include <string>
#include <vector>

namespace paper {

/// The Coulomb lines of one packing, over the stress of the lid and over that of the plane between the halves, which bears
/// weight besides and fluctuates.
struct seed_line {
  std::string seed;
  pendular::observe::coulomb_line over_lid, over_plane;
  double mean_shear;  // of all normal stresses, Pa
};

/// States of samples that differ by normal stress and seed. A line is fitted to each seed: points of one packing are not
/// independent.
struct locus {
  std::vector<double> lid, shear;  // of every run, Pa
  std::vector<seed_line> lines;
  measured bridges;  // per grain when the shear starts

  measured intercept() const;     // over the stress of the lid, Pa
  measured tan_friction() const;  // over the same
  measured lid_angle() const;     // degrees
  measured plane_angle() const;
};

/// Of the residual shear stress, or of what else summary.json has under "strength". Takes the seeds that have a run at
/// every normal stress. Errors: input_error for fewer than two normal stresses.
locus locus_of(const std::vector<seeds>& normal_stresses, const std::string& strength = "residual_shear_stress_Pa");

/// What liquid adds, seed by seed, Pa: to the intercept of the line, and to the shear stress, mean of all normal stresses,
/// which is the cohesion if the angle is that of the dry sample and has the smaller error.
measured added_intercept(const locus& wet, const locus& dry);
measured added_shear_stress(const locus& wet, const locus& dry);

}  // namespace paper
