// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measurement.hpp"
#include "program.hpp"
#include "task.hpp"

#include <pendular/io/number.hpp>

#include <string>

namespace peers::lammps {

constexpr auto program = "lmp";
constexpr double skins[] = {2e-5, 5e-5, 1e-4};  // that are tried, m

inline measurement dry(const task& t, double skin) {
  using pendular::io::shortest;
  namespace shell = pendular::io::shell;
  const std::string output = output_of(
      "", std::string{program} + " -log none -in " + shell::quoted(PENDULAR_PEERS "/dry.lammps") + " -var data " +
              shell::quoted(t.data.string()) + " -var skin " + shortest(skin) + " -var rate " + shortest(t.rate) +
              " -var warmup " + std::to_string(t.warmup) + " -var steps " + std::to_string(t.steps));
  const auto found = numbers_in(output, program,
                                R"(\n *\d+ +(\S+) +(\S+) *\nLoop time of (\S+) on 1 procs for (\d+) steps.*\n+)"
                                R"(([\d.]+)% CPU use)");
  const double seconds = found[2] * found[4] / 100;
  return {1e9 * seconds / found[3] / t.grains(), found[0] / 2, 0, found[1] / t.grains()};
}

}  // namespace peers::lammps
