// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measurement.hpp"
#include "program.hpp"
#include "task.hpp"

#include <pendular/io/number.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace peers::liggghts {

constexpr auto program = "liggghts";
constexpr double skins[] = {2e-5, 5e-5, 1e-4};  // that are tried, m

/// Its bridges form where grains touch: for a wet packing the file has grains that are larger by the reach of a bridge,
/// which shrink before the first step.
inline measurement run(const task& t, double skin, bool wet) {
  using pendular::io::shortest;
  namespace shell = pendular::io::shell;
  const std::string log = "liggghts.log";
  const std::string data = (wet ? t.inflated : t.data).string();
  output_of("", std::string{program} + " -in " + shell::quoted(PENDULAR_PEERS "/scene.liggghts") + " -var data " +
                    shell::quoted(data) + " -var skin " + shortest(skin) + " -var rate " + shortest(t.rate) +
                    " -var wet " + (wet ? "1" : "0") + " -var inflated " + shortest(wet ? t.reach : 0.0) +
                    " -var warmup " + std::to_string(t.warmup) + " -var steps " + std::to_string(t.steps) +
                    " -screen none -log " + log);
  std::ifstream in(log);
  const std::string output{std::istreambuf_iterator<char>(in), {}};
  const auto found =
      numbers_in(output, program, R"(\n *\d+ +(\S+) +(\S+) +\S+ *\nLoop time of (\S+) on 1 procs for (\d+) steps)");
  const double bridges = wet ? t.bridges : 0;
  return {1e9 * found[2] / found[3] / t.grains(), found[0] / 2 / t.grains(), bridges, found[1] / t.grains()};
}

}  // namespace peers::liggghts
