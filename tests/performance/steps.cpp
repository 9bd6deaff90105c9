// SPDX-License-Identifier: BSD-3-Clause
// ns per grain and step of the scenes that the performance page compares.
#include "packing.hpp"
#include "stopwatch.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/homogeneous.hpp>

#include <string>

using namespace pendular;

namespace {
template <class Make>
void measure(const std::string& name, const packing::sample& sample, int steps, const Make& make) {
  auto s = make(packing::box_of(sample.size, boundary::fixed{}));
  for (const grain& g : sample.grains) s.add(g);
  if constexpr (decltype(s)::wet) {
    double mass = 0;
    for (const double inverse : s.particles().template get<column::inverse_mass>()) mass += 1 / inverse;
    s.distribute_liquid(0.01 * mass / 1000);
  }
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
  const velocity_verlet clock{1e-6, {0, 0, -9.81}};
  const liquid water{fluid{0.0637, 0, 1000, 1e-3}, capillary::richefeu{}, rupture::lian{}, protocol::homogeneous{5000}};
  const run_options options{};
  if (only.empty() || only == "wet") {
    measure("wet", sample, steps, [&](const auto& walls) {
      return pendular::system{material{normal::linear{1e3}, damping::viscous{0.8}, friction::viscous_coulomb{1.0, 0.4}},
                              water, walls, clock, options};
    });
  }
  if (only.empty() || only == "spring") {
    measure("wet spring", sample, steps, [&](const auto& walls) {
      return pendular::system{
          material{normal::linear{1e3}, damping::viscous{0.8}, friction::coulomb_spring{800, 0.4}, energy_book{}},
          water, walls, clock, options};
    });
  }
  if (only.empty() || only == "dry") {
    measure("dry", sample, steps, [&](const auto& walls) {
      return pendular::system{material{normal::linear{1e3}, damping::viscous{0.8}, friction::coulomb_spring{800, 0.4}},
                              walls, clock, options};
    });
  }
  if (only.empty() || only == "smooth") {
    measure("smooth", sample, steps, [&](const auto& walls) {
      return pendular::system{material{normal::linear{1e3}, damping::viscous{0.8}}, walls, clock, options};
    });
  }
}
