// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../common/job.hpp"
#include "../common/wet_options.hpp"

#include <pendular/scene/box_packing.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// What the user may choose.
struct options : examples::job_options, examples::wet_options {
  double preparation_friction = 0;  // between grains while they are compacted
  double pressure = 300;            // that compacts them, Pa
  double confining_pressure = 0;    // on the wet sample, Pa
  double relaxation = 0.5;          // of the wet sample, at most, s
  double unbalanced_force = 1e-3;   // mean over the mean force, at which packing and sample are at rest
  std::filesystem::path packing;    // to start from, instead of making one
  std::int64_t grains = 8000;

  options();

  pendular::scene::box_packing_parameters preparation() const;
  double mean_diameter() const { return pendular::scene::mean_diameter(preparation().sizes); }  // m
  /// f0 = kappa R_max, the largest capillary force, N.
  double largest_pull() const;
  /// p0 = f0 / d^2 with the mean diameter, Pa.
  double reference_pressure() const { return largest_pull() / (mean_diameter() * mean_diameter()); }

  /// Everything that decides the results, in one line: kept in the checkpoint and compared on resume.
  std::string physics() const;
  /// What differs from the companion paper, a line each.
  std::vector<std::string> departures() const;
};

/// Errors: prints one sentence and ends the program with a code that is not 0.
options read_options(int count, char** arguments);
