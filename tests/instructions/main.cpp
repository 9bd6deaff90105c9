// SPDX-License-Identifier: BSD-3-Clause
// What valgrind counts the instructions of: `make FILE` lets 1000 grains settle, `run FILE SCENE` steps them on in a scene.
// The steps that count are those of `counted`.
#include "../performance/scenes.hpp"

#include <string>

namespace {
constexpr int warm_up = 50, steps = 200;

template <class System>
[[gnu::noinline]] void counted(System& s) {
  s.run(steps);
}

template <class System>
int run(System s) {
  s.run(warm_up);
  counted(s);
  std::printf("grain steps %zu\n", s.particles().size() * static_cast<std::size_t>(steps));
  return 0;
}

int run_scene(const std::string& name, const packing::sample& sample) {
  if (name == "wet") return run(scenes::wet(sample));
  if (name == "wet_spring") return run(scenes::wet_spring(sample));
  if (name == "wet_willett") return run(scenes::wet_willett(sample));
  if (name == "dry") return run(scenes::dry(sample));
  if (name == "smooth") return run(scenes::smooth(sample));
  std::fprintf(stderr, "no scene '%s'\n", name.c_str());
  return 1;
}
}  // namespace

int main(int count, char** arguments) {
  if (count == 3 && arguments[1] == std::string("make")) {
    packing::write(packing::settled(10, 20000), arguments[2]);
    return 0;
  }
  if (count == 4 && arguments[1] == std::string("run")) return run_scene(arguments[3], packing::read(arguments[2]));
  std::fprintf(stderr, "instructions make FILE | run FILE SCENE\n");
  return 1;
}
