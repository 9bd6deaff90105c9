// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace pendular::scene {

/// A stage is at least one step long and not so long that its steps cannot be counted.
inline void expects_steps(const char* what, double duration, double time_step, const char* page) {
  constexpr double most = 0x1p53;
  const double steps = duration / time_step;
  expects(steps >= 1 && steps <= most, what, duration, "at least one time step and at most 2^53 of them", page);
}

/// The stage of a checkpoint, one of those a scene has.
inline std::string stage_in(const io::checkpoint_reader& in, std::initializer_list<std::string_view> stages) {
  std::string stage = in.get<std::string>("scene.stage"), known;
  for (const std::string_view s : stages) {
    if (s == stage) return stage;
    known += (known.empty() ? "'" : ", '") + std::string{s} + "'";
  }
  in.refuse("holds another stage in 'scene.stage' than this scene's " + known + "; resume the scene that wrote it");
}

/// The steps that a checkpoint's stage has done, of `total`.
inline std::int64_t steps_done(const io::checkpoint_reader& in, std::int64_t total) {
  const auto done = in.get<std::int64_t>("scene.done");
  in.require(done >= 0 && done <= total, "scene.done", static_cast<double>(done),
             "0 to the stage's " + std::to_string(total) + " steps");
  return done;
}

/// How a scene reports to whoever runs it.
struct monitor {
  /// Stage, steps done and steps in all, one line of news.
  std::function<void(const std::string& stage, std::int64_t done, std::int64_t total, const std::string& news)>
      progress;
  std::filesystem::path checkpoint;          // none is written where this is empty
  std::int64_t checkpoint_interval = 50000;  // steps
  std::string label;                         // kept in the checkpoint, for whoever resumes
};

inline std::string millimetres(double length) { return std::to_string(length * 1e3).substr(0, 6) + " mm"; }

/// Runs one stage in slices, from `done` steps to `total`, or until `over` says so: after every slice `look` is called,
/// and after every checkpoint interval the list is made anew and `save` is called. All happen at fixed step numbers, so
/// a resumed run does the same as one that was never stopped.
template <class System, class Look, class Save, class Over>
void run_stage(System& s, const std::string& name, std::int64_t& done, std::int64_t total, std::int64_t slice,
               const monitor& watch, const Look& look, const Save& save, const Over& over) {
  const std::int64_t every = std::max<std::int64_t>(1, watch.checkpoint_interval / slice) * slice;
  while (done < total && !over()) {
    const std::int64_t steps = std::min(slice, total - done);
    s.run(steps);
    done += steps;
    const std::string news = look();
    if (watch.progress) watch.progress(name, done, total, news);
    if (!watch.checkpoint.empty() && done % every == 0 && done < total) {
      s.canonicalise();
      save();
    }
  }
}
template <class System, class Look, class Save>
void run_stage(System& s, const std::string& name, std::int64_t& done, std::int64_t total, std::int64_t slice,
               const monitor& watch, const Look& look, const Save& save) {
  run_stage(s, name, done, total, slice, watch, look, save, [] { return false; });
}

}  // namespace pendular::scene
