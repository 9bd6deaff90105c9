// SPDX-License-Identifier: BSD-3-Clause
// Two wet grains pulled apart until their bridge breaks and pushed together until it forms again: the force-gap cycle
// against Eq. 10 of Richefeu et al. 2007.
#include <pendular/io/plot.hpp>
#include <pendular/io/table.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/grain_films.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>

namespace {

using namespace pendular;

constexpr double radius = 0.5e-3;                           // m
constexpr double volume = 0.01 * radius * radius * radius;  // of the bridge, m3
constexpr double speed = 1e-3, step = 1e-5;                 // m/s, s

/// Eq. 10 for equal spheres and theta = 0, written out once more by hand.
double printed_force(double gap) {
  const double contact_force = 2 * std::numbers::pi * fluid::water().surface_tension * radius;
  const double decay_length = 0.9 * std::sqrt(volume / radius);
  return gap > std::cbrt(volume) ? 0 : contact_force * std::exp(-std::max(gap, 0.0) / decay_length);
}

// [composition]
// Grains so heavy that their motion is as good as prescribed: the law is measured as a testing machine would.
auto heavy_pair() {
  pendular::system pair{material{normal::linear{1e3}},
                        liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}},
                        boundary::walls{}, velocity_verlet{step}};
  constexpr double heavy = 1e12;  // kg/m3
  pair.add({{0, 0, 0}, radius, heavy, {0, 0, 0}});
  pair.add({{2 * radius - 1e-8, 0, 0}, radius, heavy, {speed, 0, 0}});
  pair.distribute_liquid(volume);
  return pair;
}
// [/composition]

template <class Pair>
void turn_round(Pair& pair) {
  for (vector& v : pair.particles().template get<column::velocity>()) v = -v;
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "two_grains";
  auto pair = heavy_pair();
  io::table cycle{"gap_um", "attraction_uN", "eq_10_uN"};
  double worst = 0;
  const auto look = [&](bool opening) {
    // Of the grains, not of their pair, which leaves the neighbour list some time after its bridge broke.
    const auto rows = pair.particles().rows_by_id();
    const auto position = pair.particles().get<column::position>();
    const double gap = norm(position[rows[1]] - position[rows[0]]) - 2 * radius;
    const double attraction = pair.particles().get<column::force>()[rows[0]].x + 1e3 * std::max(-gap, 0.0);
    cycle.add_row({1e6 * gap, 1e6 * attraction, 1e6 * printed_force(gap)});
    if (opening) worst = std::max(worst, std::abs(attraction - printed_force(gap)));
  };
  const auto steps = static_cast<int>(1.3 * std::cbrt(volume) / (speed * step));
  for (int k = 0; k < steps; k += 20) pair.run(20), look(true);
  const std::int64_t ruptures = pair.events().ruptures;
  turn_round(pair);
  for (int k = 0; k < steps + 200; k += 20) pair.run(20), look(false);

  io::write_table(folder / "force_gap.csv", cycle);
  io::plot picture{"A wet pair: force over a cycle of the gap", "gap (µm)", "attraction (µN)", {}};
  const auto half = static_cast<std::ptrdiff_t>((steps + 19) / 20);
  const auto part = [&](const char* name, bool first) {
    const auto& all = cycle[name];
    return first ? std::vector<double>(all.begin(), all.begin() + half)
                 : std::vector<double>(all.begin() + half, all.end());
  };
  picture.curves = {{"pulled apart", part("gap_um", true), part("attraction_uN", true), io::curve_style::points},
                    {"pushed together", part("gap_um", false), part("attraction_uN", false), io::curve_style::lines},
                    {"Eq. 10", part("gap_um", true), part("eq_10_uN", true), io::curve_style::dashed}};
  io::draw(picture, folder / "force_gap.png");
  std::printf("contact force %.5e N, rupture at %.3f um, worst difference from Eq. 10 %.1e of it\n", printed_force(0),
              1e6 * std::cbrt(volume), worst / printed_force(0));
  std::printf("%lld rupture, %lld bridges at the end, liquid kept to %.1e\nResults in %s\n",
              static_cast<long long>(ruptures), static_cast<long long>(pair.bridges().count()),
              pair.bridges().book().total() / volume - 1, folder.string().c_str());
  const bool as_expected = worst < 1e-3 * printed_force(0) && ruptures == 1 && pair.bridges().count() == 1;
  return as_expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
