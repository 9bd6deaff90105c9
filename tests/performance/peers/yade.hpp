// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measurement.hpp"
#include "program.hpp"
#include "task.hpp"

#include <pendular/io/number.hpp>

#include <string>

namespace peers::yade {

constexpr auto program = "yade";
constexpr double skins[] = {1e-5, 5e-5, 2e-4};  // that are tried, m

inline measurement wet(const task& t, double skin) {
  using pendular::io::shortest;
  namespace shell = pendular::io::shell;
  const std::string settings = "DATA=" + shell::quoted(t.data.string()) + " REACH=" + shortest(t.reach) +
                               " VOLUME=" + shortest(t.volume) + " SKIN=" + shortest(skin) +
                               " WARMUP=" + std::to_string(t.warmup) + " STEPS=" + std::to_string(t.steps);
  const std::string output =
      output_of(settings, std::string{program} + " -j1 -n -x " + shell::quoted(PENDULAR_PEERS "/wet.py"));
  const auto found = numbers_in(
      output, program, R"((\S+) ns per grain and step, bridges (\S+), contacts (\S+), kinetic energy (\S+) J)");
  return {found[0], found[2], found[1], found[3]};
}

}  // namespace peers::yade
