// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include "../../examples/common/snapshot.hpp"
#include "../io/scratch.hpp"

#include <pendular/io/collection.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

/// Two grains and a bond between them, whose numbers do not matter here.
examples::snapshot shot_at(double time) {
  const std::vector<double> two{0, 1}, one{1};
  return {time, two, two, two, two, two, two, two, two, two, {{0, 1}}, one, one, one};
}

std::vector<std::pair<double, std::string>> listed(const std::filesystem::path& path) {
  std::vector<std::pair<double, std::string>> frames;
  const pendular::io::collection series(path);
  for (const auto& e : series.entries()) frames.emplace_back(e.time, e.file.filename().string());
  return frames;
}

}  // namespace

TEST_CASE("the series of a job that was killed and resumed is that of one that was left alone") {
  const scratch::folder folder;
  examples::job_options o;
  // The times of a job are whole steps, at intervals that are only nearly equal.
  const std::vector<double> times{0, 0.1003, 0.2001, 0.3002, 0.4};
  for (const char* name : {"whole", "killed"}) {
    o.output = folder / name;
    for (int k = 0; k < 4; ++k) write_snapshot(o, shot_at(times[static_cast<std::size_t>(k)]), k);
  }
  // Killed after frame 3 and resumed from before frame 2.
  for (int k = 2; k < 5; ++k) write_snapshot(o, shot_at(times[static_cast<std::size_t>(k)]), k);
  o.output = folder / "whole";
  write_snapshot(o, shot_at(times[4]), 4);
  for (const std::string stem : {"grains", "bonds"}) {
    std::vector<std::pair<double, std::string>> expected;
    for (int k = 0; k < 5; ++k)
      expected.emplace_back(times[static_cast<std::size_t>(k)], stem + "_000" + std::to_string(k) + ".vtp");
    CHECK(listed(folder / "whole" / (stem + ".pvd")) == expected);
    CHECK(listed(folder / "killed" / (stem + ".pvd")) == expected);
  }
  // Started anew in the same folder, with a first frame that is later than the old one.
  write_snapshot(o, shot_at(0.05), 0);
  CHECK(listed(folder / "whole/grains.pvd").size() == 1);
}
