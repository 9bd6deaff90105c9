// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/checkpoint.hpp>
#include <pendular/scene/stages.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace examples {

/// What every job may be told, besides its physics.
struct job_options {
  std::filesystem::path output;
  std::uint64_t seed = 1;
  int threads = 0;                           // 0: as many as the machine has
  std::int64_t checkpoint_interval = 50000;  // steps
  int snapshots = 8;
  bool resume = false;
  bool go_on = false;  // resume if there is a checkpoint
  bool packing_only = false;
  bool force = false;
  bool pictures = true;
};

/// The checkpoint to go on from, if any.
using restart = std::optional<pendular::io::checkpoint_reader>;

/// Seconds of a clock that never goes back.
double seconds();
/// Since the program started.
double seconds_since_start();
/// Seconds of work of all threads of this program.
double processor_seconds();
int thread_count();

/// What identifies a file to start from: its content, wherever it lies; "none" for no file.
std::string label_of(const std::filesystem::path& file);

/// Calls `work` with the checkpoint and with a monitor that shows progress and writes checkpoints into the folder of the
/// job. `physics` is everything that decides the results, kept in the checkpoint and compared on resume. An error
/// becomes one line on the standard error. Answers the exit code.
int run_job(const std::string& program, const job_options& o, const std::string& physics,
            const std::function<void(const restart&, const pendular::scene::monitor&)>& work);

}  // namespace examples
