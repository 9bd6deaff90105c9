// SPDX-License-Identifier: BSD-3-Clause
// One of our scenes in a program of its own, which is built for several instruction sets: SCENE GRAINS WARMUP STEPS, in the
// folder of the packing. Ends with 77 on a machine without the instructions.
#include "../../instruction_set.hpp"
#include "ours.hpp"

#include <cstdlib>
#include <string>

using namespace peers;

namespace {

template <class Make>
int print(const packing::sample& sample, int warmup, int steps, const Make& make) {
  const measurement m = measured(sample, warmup, steps, make);
  std::printf("%.17g ns per grain and step, bridges %.17g, contacts %.17g, kinetic energy %.17g J\n", m.time, m.bridges,
              m.contacts, m.kinetic_energy);
  return EXIT_SUCCESS;
}

int run(const std::string& scene, const packing::sample& sample, int warmup, int steps) {
  if (scene == "wet") return print(sample, warmup, steps, scenes::wet);
  if (scene == "dry") return print(sample, warmup, steps, scenes::dry);
  if (scene == "wet_willett") return print(sample, warmup, steps, scenes::wet_willett);
  if (scene == "smooth") return print(sample, warmup, steps, scenes::smooth);
  std::fprintf(stderr, "no scene '%s'\n", scene.c_str());
  return EXIT_FAILURE;
}

}  // namespace

int main(int count, char** arguments) {
  if (!has_instructions_of_build()) return not_on_this_machine;
  if (count == 1) return EXIT_SUCCESS;
  if (count != 5) {
    std::fprintf(stderr, "own SCENE GRAINS WARMUP STEPS\n");
    return EXIT_FAILURE;
  }
  const auto sample = packing::of_size(packing::block("packing_8000.bin"), std::stoul(arguments[2]));
  return run(arguments[1], sample, std::stoi(arguments[3]), std::stoi(arguments[4]));
}
