// SPDX-License-Identifier: BSD-3-Clause
// How far the scenes are from what the machine can do at best: from moving the bytes they hold through one core in order,
// and from executing the instructions of a step (tests/instructions/counts.txt) at the pace of instructions that do nothing.
#include "median.hpp"
#include "memory.hpp"
#include "scenes.hpp"
#include "stopwatch.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace {
constexpr int rounds = 9;

/// ns to read an array of so many bytes in order and to write half of it, which is what a step does to its rows.
double time_of_moving(double bytes) {
  std::vector<double> numbers(static_cast<std::size_t>(bytes / sizeof(double)), 1.0);
  constexpr std::size_t line = 16;  // numbers: two lines of the cache, of which one is written
  double sum = 0;
  const auto pass = [&] {
    for (std::size_t k = 0; k + line <= numbers.size(); k += line) {
      const auto low = pendular::load(&numbers[k]), high = pendular::load(&numbers[k + line / 2]);
      pendular::store(&numbers[k], 0.5 * (low + high));
    }
    sum += numbers[0];
  };
  pass();
  std::vector<double> times;
  for (int k = 0; k < rounds; ++k)
    times.push_back(1e9 * processor_time([&] {
                      for (int n = 0; n < 20; ++n) pass();
                    }) /
                    20);
  return sum > 0 ? *std::min_element(times.begin(), times.end()) : 0;
}

/// ns per instruction that does nothing and waits for nobody.
double time_of_instruction() {
  constexpr int block = 512, repeats = 200'000;
  const auto work = [] {
    for (int k = 0; k < repeats; ++k) asm volatile(".rept 512\n nop\n .endr" ::);
  };
  double least = processor_time(work);
  for (int k = 1; k < rounds; ++k) least = std::min(least, processor_time(work));
  return 1e9 * least / repeats / block;
}

template <class Make>
void measure(const char* name, const packing::sample& sample, const Make& make) {
  const double grains = static_cast<double>(sample.grains.size()), before = memory();
  auto s = make(sample);
  s.run(150);
  const double bytes = memory() - before;
  double least = 1e300;
  for (int k = 0; k < rounds; ++k) least = std::min(least, 1e9 * processor_time([&] { s.run(100); }) / 100);
  const double moving = time_of_moving(bytes);
  std::printf("| %s | %.0f | %.0f | %.0f | %.2f |\n", name, least / grains, bytes / grains, moving / grains,
              moving / least);
}
}  // namespace

int main(int count, char** arguments) {
  const auto sample = packing::of_size(packing::block("packing_8000.bin"), count > 1 ? std::stoul(arguments[1]) : 8000);
  std::printf("%zu grains; an instruction takes %.3f ns at best\n", sample.grains.size(), time_of_instruction());
  std::printf("| scene | ns per grain and step | bytes per grain | ns to move them | share of the step "
              "|\n|---|---|---|---|---|\n");
  measure("wet", sample, scenes::wet);
  measure("dry", sample, scenes::dry);
  measure("smooth", sample, scenes::smooth);
}
