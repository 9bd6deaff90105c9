// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measured.hpp"
#include "run.hpp"

#include <string>
#include <vector>

namespace paper {

/// Mean Coulomb line of the seeds, each of which has one of its own: points of one packing are not independent.
struct mean_line {
  measured cohesion;      // Pa
  measured tan_friction;  // and its angle
  measured angle;         // degrees
};

/// States of samples that differ by normal stress and seed, and the lines through them.
struct locus {
  std::vector<double> plane, shear;  // of every run, Pa; the plane between the halves bears weight besides the lid
  mean_line over_lid, over_plane;
  measured bridges;  // per grain when the shear starts
};

/// Of the residual shear stress, or of what else summary.json has under "strength". Takes the seeds that have a run at
/// every normal stress. Errors: input_error for fewer than two normal stresses.
locus locus_of(const std::vector<seeds>& normal_stresses, const std::string& strength = "residual_shear_stress_Pa");

}  // namespace paper
