// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts.hpp"
#include "job.hpp"
#include "snapshot.hpp"

#include <pendular/core/vec.hpp>
#include <pendular/scene/packing.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace examples {

/// A scene at its start, on the packing that `prepare` makes, or where a checkpoint of it stopped. Answers whether there
/// is more to do than the packing.
template <class Scene, class Prepare>
bool begin(Scene& scene, const job_options& o, const restart& from, const Prepare& prepare) {
  const auto stage = from ? from->template get<std::string>("scene.stage") : "deposit";
  const bool prepared = stage != "deposit" && stage != "seal";
  if (prepared && !o.packing_only) scene.resume(*from);
  if (prepared) return !o.packing_only;
  const pendular::scene::sealed_packing packing = prepare();
  if (!o.packing_only) scene.start(packing);
  return !o.packing_only;
}

/// What a job sees of its test while it runs: snapshots at even intervals, time and steps.
class observed {
 public:
  /// `whole` is the length of the test in what it counts, seconds or metres; `way` and `lines` of its curve are done.
  observed(const job_options& o, double whole, double way, std::size_t lines)
      : options_(o), interval_(o.snapshots > 0 ? whole / o.snapshots : 0), lines_before_(lines) {
    if (lines > 0 && o.snapshots > 0) shots_ = static_cast<int>(std::floor(way / interval_ + tolerance)) + 1;
  }

  void test_begins() { test_began_ = seconds(), work_began_ = processor_seconds(); }

  template <class System>
  void look(const System& s, const std::vector<pendular::vector>& reference, double way, double time) {
    if (options_.snapshots == 0 || way < (shots_ - tolerance) * interval_) return;
    write_snapshot(options_, take(s, reference, time), shots_++);
  }

  /// All of this program, which may have gone on from a checkpoint. A line of the curve takes so many seconds.
  void put(run_facts& f, std::size_t lines, double seconds_per_line, double time_step) const {
    f.wall_time = seconds_since_start();
    f.test_time = seconds() - test_began_;
    f.test_processor_time = processor_seconds() - work_began_;
    f.test_steps = static_cast<std::int64_t>(lines - lines_before_) *
                   std::max<std::int64_t>(1, std::llround(seconds_per_line / time_step));
  }

 private:
  static constexpr double tolerance = 1e-3;  // of an interval: a test ends on a whole step

  const job_options& options_;
  double interval_;
  std::size_t lines_before_;
  int shots_ = 0;
  double test_began_ = seconds(), work_began_ = processor_seconds();
};

}  // namespace examples
