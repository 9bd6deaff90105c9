// SPDX-License-Identifier: BSD-3-Clause
// How the wet scene grows: time per grain and step over the number of grains, what a second thread brings, and memory.
// Every size is measured in turns with 8000 grains, so that the ratio does not follow the moods of the machine.
#include "median.hpp"
#include "memory.hpp"
#include "scenes.hpp"
#include "stopwatch.hpp"

#include <pendular/io/plot.hpp>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <filesystem>
#include <string>

namespace {
constexpr int rounds = 5;
constexpr double grain_steps = 2e6;  // of a slice

void use_threads(int count) {
#ifdef _OPENMP
  omp_set_num_threads(count);
#else
  (void)count;
#endif
}

/// ns per grain and step of a slice.
template <class System>
double slice(System& s, int threads) {
  use_threads(threads);
  const double grains = static_cast<double>(s.particles().size());
  const auto steps = static_cast<std::int64_t>(std::max(2.0, grain_steps / grains));
  return 1e9 * timed([&] { s.run(steps); }) / static_cast<double>(steps) / grains;
}

struct growth {
  double grains, time, over_8000, second_thread, bytes;
};

template <class System>
growth measure(System& small, const packing::sample& sample) {
  const double before = memory();
  System s = scenes::wet(sample);
  slice(s, 1);
  const double bytes = (memory() - before) / static_cast<double>(sample.grains.size());
  std::vector<double> times, ratios, gains;
  for (int round = 0; round < rounds; ++round) {
    const double reference = slice(small, 1);
    times.push_back(slice(s, 1));
    ratios.push_back(times.back() / reference);
    gains.push_back(times.back() / slice(s, 2));
  }
  return {static_cast<double>(sample.grains.size()), median(times), median(ratios), median(gains), bytes};
}
}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path folder = count > 1 ? arguments[1] : ".";
  const std::size_t largest = count > 2 ? std::stoul(arguments[2]) : 1000000;
  const auto block = packing::block("packing_8000.bin");
  auto small = scenes::wet(block);
  slice(small, 1);
  pendular::io::plot picture{"Wet scene, against 8000 grains measured in turns",
                             "grains",
                             "time per grain and step over that of 8000 grains",
                             {}};
  picture.curves.push_back({"one thread", {}, {}, pendular::io::curve_style::linespoints});
  std::printf("| grains | ns per grain and step | over that of 8000 | one thread over two | bytes per grain |\n"
              "|---|---|---|---|---|\n");
  for (const std::size_t grains : {1000, 2000, 4000, 8000, 24000, 96000, 320000, 1000000}) {
    if (grains > largest) break;
    const growth g = measure(small, packing::of_size(block, grains));
    std::printf("| %.0f | %.0f | %.2f | %.2f | %.0f |\n", g.grains, g.time, g.over_8000, g.second_thread, g.bytes);
    std::fflush(stdout);
    picture.curves[0].x.push_back(g.grains);
    picture.curves[0].y.push_back(g.over_8000);
  }
  picture.logarithmic_x = true;
  std::filesystem::create_directories(folder);
  for (const char* kind : {"growth.png", "growth.svg"}) pendular::io::draw(picture, folder / kind);
}
