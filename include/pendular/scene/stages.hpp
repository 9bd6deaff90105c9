// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular::scene {

/// A stage is at least one step long and not so long that its steps cannot be counted.
inline void expects_steps(const char* what, double duration, double time_step, const char* page) {
  constexpr double most = 0x1p53;
  const double steps = duration / time_step;
  expects(steps >= 1 && steps <= most, what, duration, "at least one time step and at most 2^53 of them", page);
}

/// The steps nearest to a duration, s.
inline std::int64_t steps_in(double duration, double time_step) { return std::llround(duration / time_step); }

/// How many steps a scene takes between two looks that are so far apart, s.
inline std::int64_t slice_of(double interval, double time_step) {
  return std::max<std::int64_t>(1, steps_in(interval, time_step));
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

/// The stages of a scene, which follow each other, and where in them it is. Written with every checkpoint and read from
/// it.
class stages {
 public:
  struct stage {
    std::string name;
    double duration;  // at most, s
  };
  stages(double time_step, std::vector<stage> all) : all_(std::move(all)), time_step_(time_step) {}

  bool at(std::string_view name) const { return all_[now_].name == name; }
  std::int64_t steps() const { return steps_in(all_[now_].duration, time_step_); }  // of this stage
  std::int64_t done() const { return done_; }                                       // of these
  double time() const { return static_cast<double>(done_) * time_step_; }           // since this stage began, s

  /// The next one begins.
  void next() {
    ++now_;
    done_ = 0;
  }

  /// Runs this stage in slices to its end, or until `over` says so: after every slice `look` is called for the news, and
  /// after every checkpoint interval the list is made anew and a checkpoint written, to which `put` adds the scene's own.
  /// All happen at fixed step numbers, so a resumed run does the same as one that was never stopped.
  template <class System, class Look, class Put, class Over>
  void run(System& s, std::int64_t slice, const monitor& watch, const Look& look, const Put& put, const Over& over) {
    const std::int64_t every = std::max<std::int64_t>(1, watch.checkpoint_interval / slice) * slice, total = steps();
    while (done_ < total && !over()) {
      const std::int64_t next = std::min(slice, total - done_);
      s.run(next);
      done_ += next;
      const std::string news = look();
      if (watch.progress) watch.progress(all_[now_].name, done_, total, news);
      if (!watch.checkpoint.empty() && done_ % every == 0 && done_ < total) {
        s.canonicalise();
        save(watch, put);
      }
    }
  }
  template <class System, class Look, class Put>
  void run(System& s, std::int64_t slice, const monitor& watch, const Look& look, const Put& put) {
    run(s, slice, watch, look, put, [] { return false; });
  }

  /// These stages, where the scene of a checkpoint was in them. Errors: std::runtime_error for one of another scene.
  stages read(const io::checkpoint_reader& in) const {
    stages there = *this;
    there.now_ = place_in(in);
    there.done_ = in.get<std::int64_t>("scene.done");
    in.require(there.done_ >= 0 && there.done_ <= there.steps(), "scene.done", static_cast<double>(there.done_),
               "0 to the stage's " + std::to_string(there.steps()) + " steps");
    return there;
  }

 private:
  std::size_t place_in(const io::checkpoint_reader& in) const {
    const auto name = in.get<std::string>("scene.stage");
    std::string known;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (all_[k].name == name) return k;
      known += (known.empty() ? "'" : ", '") + all_[k].name + "'";
    }
    in.refuse("holds another stage in 'scene.stage' than this scene's " + known + "; resume the scene that wrote it");
  }

  template <class Put>
  void save(const monitor& watch, const Put& put) const {
    io::checkpoint_writer out(watch.checkpoint);
    out.put("scene.label", std::string_view{watch.label});
    out.put("scene.stage", std::string_view{all_[now_].name});
    out.put("scene.done", done_);
    put(out);
    out.commit();
  }

  std::vector<stage> all_;
  double time_step_;  // s
  std::size_t now_ = 0;
  std::int64_t done_ = 0;
};

}  // namespace pendular::scene
