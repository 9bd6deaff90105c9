// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../median.hpp"
#include "measurement.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace peers {

/// A code with its scene, and what it did in every round.
struct contender {
  std::string code, scene;
  std::function<measurement()> run;
  std::vector<measurement> rounds = {};

  double time() const {
    std::vector<double> times;
    for (const measurement& m : rounds) times.push_back(m.time);
    return median(times);
  }
};

/// All of them in turns, so that what slows the machine down for a while slows all of them.
inline void run_in_turns(std::vector<contender>& all, int rounds) {
  for (int k = 0; k < rounds; ++k) {
    for (contender& c : all) c.rounds.push_back(c.run());
  }
}

/// How many times as long as `other` one took, round by round.
struct ratio {
  double median, smallest, largest;
};
inline ratio time_ratio(const contender& one, const contender& other) {
  std::vector<double> all;
  for (std::size_t k = 0; k < one.rounds.size(); ++k) all.push_back(one.rounds[k].time / other.rounds.at(k).time);
  const auto [smallest, largest] = std::minmax_element(all.begin(), all.end());
  return {::median(all), *smallest, *largest};
}

}  // namespace peers
