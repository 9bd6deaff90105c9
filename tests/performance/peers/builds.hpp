// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measurement.hpp"
#include "program.hpp"
#include "task.hpp"

#include <string>

// This library as users have it: programs for any x86-64 (a plain Release build), for AVX2 and for AVX-512.
namespace peers::builds {

struct build {
  const char* name;
  const char* machine;  // as in -march
};
constexpr build all[] = {
    {"pendular, SSE2", "x86-64"}, {"pendular, AVX2", "x86-64-v3"}, {"pendular, AVX-512", "x86-64-v4"}};

inline std::string program_of(const build& b) { return std::string{PENDULAR_OWN_BUILDS} + b.machine; }

inline bool runs_here(const build& b) {
  return pendular::io::shell::run(pendular::io::shell::quoted(program_of(b))).status == 0;
}

inline measurement run(const build& b, const task& t, const std::string& scene) {
  const std::string command = pendular::io::shell::quoted(program_of(b)) + " " + scene + " " +
                              std::to_string(t.sample.grains.size()) + " " + std::to_string(t.warmup) + " " +
                              std::to_string(t.steps);
  const auto found =
      numbers_in(output_of("", command), b.name,
                 R"((\S+) ns per grain and step, bridges (\S+), contacts (\S+), kinetic energy (\S+) J)");
  return {found[0], found[2], found[1], found[3]};
}

}  // namespace peers::builds
