// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

/// What the user may choose; the defaults are the README's main job.
struct options {
  std::filesystem::path output = "simple_compression";
  double water_content = 0.02;
  std::string protocol = "homogeneous";
  std::string law = "richefeu";
  std::string friction = "coulomb-spring";
  double thinning = 1;
  double surface_tension_force = 0.4;  // kappa = 2 pi gamma_s cos(theta), N/m
  double wall_speed = 1e-3;            // m/s
  double duration = 2;                 // s
  double time_step = 8e-6;             // s, of the test; the preparation has time_step / sqrt(mass_scaling)
  double mass_scaling = 4;
  double preparation_friction = 0;
  std::filesystem::path packing;  // to start from, instead of making one
  std::int64_t grains = 8000;
  std::uint64_t seed = 1;
  int threads = 0;                           // 0: as many as the machine has
  std::int64_t checkpoint_interval = 50000;  // steps
  int snapshots = 8;
  bool resume = false;
  bool force = false;
  bool pictures = true;

  /// Everything that decides the results, in one line: kept in the checkpoint and compared on resume.
  std::string physics() const;
};

/// Errors: prints one sentence and ends the program with a code that is not 0.
options read_options(int argc, char** argv);
