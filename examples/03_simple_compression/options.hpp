// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../common/job.hpp"
#include "../common/wet_options.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// What the user may choose; the defaults are the README's main job.
struct options : examples::job_options, examples::wet_options {
  double wall_speed = 1e-3;  // m/s
  double duration = 2;       // s
  double relaxation = 0.1;   // s
  double preparation_friction = 0;
  std::filesystem::path packing;  // to start from, instead of making one
  std::int64_t grains = 8000;

  options() {
    output = "simple_compression";
    // 64 times the mass change the strength by 0.7 +- 0.8 % (docs/explanation/convergence.md).
    time_step = 3.2e-5;
    mass_scaling = 64;
  }

  double cylinder_radius() const;  // m

  /// Everything that decides the results, in one line: kept in the checkpoint and compared on resume.
  std::string physics() const;
  /// What differs from the paper, a line each.
  std::vector<std::string> departures() const;
};

/// Errors: prints one sentence and ends the program with a code that is not 0.
options read_options(int count, char** arguments);
