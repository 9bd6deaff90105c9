// SPDX-License-Identifier: BSD-3-Clause
// The stages of a scene by themselves: what is run, told and written at which step, and where a resumed one goes on.
#include "../catch.hpp"
#include "../io/scratch.hpp"

#include <pendular/scene/stages.hpp>

#include <cstdint>
#include <string>
#include <vector>

using namespace pendular;

namespace {
/// Counts its steps, and remembers at which its list was made anew.
struct counter {
  std::int64_t steps = 0;
  std::vector<std::int64_t> relisted;
  void run(std::int64_t more) { steps += more; }
  void canonicalise() { relisted.push_back(steps); }
};

/// A scene of two stages of 12 and 7 steps, in slices of 3.
struct scene_of_two {
  counter system;
  scene::stages now{0.1, {{"fall", 1.2}, {"rest", 0.7}}};
  std::vector<std::string> told;
  std::int64_t enough = 100;

  void run(scene::monitor watch) {
    watch.progress = [&](const std::string& stage, std::int64_t done, std::int64_t total, const std::string& news) {
      told.push_back(stage + " " + std::to_string(done) + "/" + std::to_string(total) + " " + news);
    };
    const auto look = [&] { return "at " + std::to_string(now.done()); };
    const auto put = [&](io::checkpoint_writer& out) { out.put("steps", system.steps); };
    if (now.at("fall")) {
      now.run(system, 3, watch, look, put, [&] { return system.steps >= enough; });
      now.next();
    }
    now.run(system, 3, watch, look, put);
  }
};
}  // namespace

TEST_CASE("stages are run in slices, the last one shorter, and told of in each") {
  scene_of_two s;
  CHECK((s.now.steps() == 12 && s.now.done() == 0));
  s.run({});
  CHECK(s.told == std::vector<std::string>{"fall 3/12 at 3", "fall 6/12 at 6", "fall 9/12 at 9", "fall 12/12 at 12",
                                           "rest 3/7 at 3", "rest 6/7 at 6", "rest 7/7 at 7"});
  CHECK((s.system.steps == 19 && s.system.relisted.empty()));
  CHECK((s.now.at("rest") && s.now.done() == 7 && s.now.time() == within(1e-15, 0.7)));
}

TEST_CASE("a stage ends early where the scene says so, which is asked before every slice") {
  scene_of_two s;
  s.enough = 5;
  s.run({});
  CHECK(s.told.at(1) == "fall 6/12 at 6");
  CHECK(s.told.at(2) == "rest 3/7 at 3");
}

TEST_CASE("checkpoints come at whole slices, not at the end of a stage, and a scene goes on from each of them") {
  const scratch::folder folder;
  scene::monitor watch;
  watch.checkpoint = folder / "c";
  watch.checkpoint_interval = 7;  // every 6 steps, being two slices
  scene_of_two all;
  all.run(watch);
  CHECK(all.system.relisted == std::vector<std::int64_t>{6, 18});

  const io::checkpoint_reader in(folder / "c");  // the last, written at step 6 of the second stage
  scene_of_two resumed;
  resumed.now = resumed.now.read(in);
  resumed.system.steps = in.get<std::int64_t>("steps");
  CHECK((resumed.now.at("rest") && resumed.now.done() == 6 && resumed.system.steps == 18));
  resumed.run({});
  CHECK(resumed.told == std::vector<std::string>{"rest 7/7 at 7"});
  CHECK(resumed.system.steps == all.system.steps);
}
