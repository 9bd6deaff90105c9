// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../io/scratch.hpp"

#include <pendular/scene/stages.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace checkpoints {

/// Keeps a copy of every checkpoint under the name of stage and step.
inline pendular::scene::monitor watching(const scratch::folder& folder, std::int64_t interval,
                                         std::vector<std::filesystem::path>& kept) {
  pendular::scene::monitor watch;
  watch.checkpoint = folder / "checkpoint";
  watch.checkpoint_interval = interval;
  watch.progress = [&folder, &kept](const std::string& stage, std::int64_t done, std::int64_t, const std::string&) {
    // Called before the checkpoint of this slice is written: what lies there is that of an earlier one.
    if (!std::filesystem::exists(folder / "checkpoint")) return;
    const std::filesystem::path copy = folder / (stage + "." + std::to_string(done));
    if (!kept.empty() && scratch::content(kept.back()) == scratch::content(folder / "checkpoint")) return;
    std::filesystem::copy_file(folder / "checkpoint", copy);
    kept.push_back(copy);
  };
  return watch;
}

inline pendular::scene::monitor written_to(const std::filesystem::path& path, std::int64_t interval) {
  pendular::scene::monitor watch;
  watch.checkpoint = path;
  watch.checkpoint_interval = interval;
  return watch;
}

inline std::string stage_in(const std::filesystem::path& checkpoint) {
  return pendular::io::checkpoint_reader(checkpoint).get<std::string>("scene.stage");
}

}  // namespace checkpoints
