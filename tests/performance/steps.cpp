// SPDX-License-Identifier: BSD-3-Clause
// ns per grain and step of the scenes that the performance page compares.
#include "scenes.hpp"
#include "stopwatch.hpp"

#include <string>

namespace {
template <class Make>
void measure(const std::string& name, const packing::sample& sample, int steps, const Make& make) {
  auto s = make(sample);
  s.run(steps / 4);
  const auto rebuilds = s.rebuild_count();
  const double each = 1e9 * timed([&] { s.run(steps); }) / steps / static_cast<double>(sample.grains.size());
  double bonds = 0;
  if constexpr (decltype(s)::wet) bonds = static_cast<double>(s.bridges().count());
  const double n = static_cast<double>(sample.grains.size());
  double touching = 0;
  for (std::size_t p = 0; p < s.pairs().size(); ++p) touching += s.contacts().gap()[p] < 0;
  std::printf("%-12s %8zu grains  %7.2f ns per grain and step  pairs %.2f bonds %.2f contacts %.2f  rebuilds %ld\n",
              name.c_str(), sample.grains.size(), each, static_cast<double>(s.pairs().size()) / n, bonds / n,
              touching / n, static_cast<long>(s.rebuild_count() - rebuilds));
}
}  // namespace

int main(int count, char** arguments) {
  const std::size_t grains = count > 1 ? std::stoul(arguments[1]) : 8000;
  const int steps = count > 2 ? std::stoi(arguments[2]) : 2000;
  const std::string only = count > 3 ? arguments[3] : "";
  const auto sample = packing::of_size(packing::block("packing_8000.bin"), grains);
  if (only.empty() || only == "wet") measure("wet", sample, steps, scenes::wet);
  if (only.empty() || only == "spring") measure("wet spring", sample, steps, scenes::wet_spring);
  if (only.empty() || only == "dry") measure("dry", sample, steps, scenes::dry);
  if (only.empty() || only == "smooth") measure("smooth", sample, steps, scenes::smooth);
}
