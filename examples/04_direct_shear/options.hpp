// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../common/job.hpp"
#include "../common/wet_options.hpp"

#include <pendular/scene/grading.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// What the user may choose. A water content of 0 makes a scene without any liquid.
struct options : examples::job_options, examples::wet_options {
  double normal_stress = 300;         // Pa
  double shear_speed = 5e-3;          // m/s
  double displacement = 5e-3;         // m
  double preparation_friction = 0.4;  // between grains while they are deposited
  double solid_fraction = 0.57;       // over the cell, at which friction comes after the consolidation without
  double wall_friction = 0;           // of both halves
  double plate_friction = 0.4;        // of floor and lid
  double scale = 1;                   // of grains and cell over the paper's
  double residual_from = 2;           // mean diameters
  std::filesystem::path packing;      // to start from, instead of making one
  std::int64_t grains = 7307;

  options();

  bool dry() const { return water_content == 0; }
  double cell_radius() const;  // m
  pendular::scene::grading grain_sizes() const;

  /// Everything that decides the results, in one line: kept in the checkpoint and compared on resume.
  std::string physics() const;
  /// What differs from the paper, a line each.
  std::vector<std::string> departures() const;
};

/// Errors: prints one sentence and ends the program with a code that is not 0.
options read_options(int count, char** arguments);
