// SPDX-License-Identifier: BSD-3-Clause
// The library's wet scene against the same scene written by hand, in turns: time per grain and step, and how far apart the
// grains end.
#include "yardstick.hpp"
#include "median.hpp"
#include "packing.hpp"
#include "stopwatch.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/none.hpp>

#include <algorithm>
#include <string>

using namespace pendular;

int main(int count, char** arguments) {
  const std::size_t grains = count > 1 ? std::stoul(arguments[1]) : 8000;
  const int slice = count > 2 ? std::stoi(arguments[2]) : 200, rounds = 9;
  const auto sample = packing::of_size(packing::block("packing_8000.bin"), grains);
  const yardstick::parameters p;
  const liquid water{fluid{p.kappa / (2 * std::numbers::pi), 0, 1000, 1e-3}, capillary::richefeu{}, rupture::lian{}};
  pendular::system s{material{normal::linear{p.stiffness}, damping::viscous{p.damping},
                              friction::viscous_coulomb{p.viscosity, p.friction}},
                     water, packing::box_of(sample.size, boundary::fixed{}),
                     velocity_verlet{p.time_step, {0, 0, p.gravity}}};
  double mass = 0;
  for (const grain& g : sample.grains) {
    s.add(g);
    mass += 4.0 / 3 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
  }
  s.distribute_liquid(0.01 * mass / 1000);
  yardstick::wet_box hand(sample.grains, sample.size, p);
  const auto view = s.view();
  std::set<std::pair<std::int64_t, std::int64_t>> bridges;
  double alpha = 0;
  for (std::size_t k = 0; k < view.pairs; ++k) {
    if (!s.bridges().is_bonded(k)) continue;
    bridges.insert(view.ids(k));
    alpha = s.bridges().book().bonds()[k] / bond_size(view.bridge_of(k, 0, 0));
  }
  hand.wet(alpha, bridges);
  const auto rebuilds = s.rebuild_count();
  const int by_hand = hand.rebuilds();
  std::vector<double> ratios, library, own;
  for (int round = 0; round < rounds; ++round) {
    library.push_back(timed([&] { s.run(slice); }));
    own.push_back(timed([&] {
      for (int k = 0; k < slice; ++k) hand.step();
    }));
    ratios.push_back(library.back() / own.back());
  }
  const auto x = hand.positions_by_id();
  const auto rows = s.particles().rows_by_id();
  double apart = 0;
  for (std::size_t id = 0; id < rows.size(); ++id) {
    apart = std::max(apart, norm(x[id] - s.particles().get<column::position>()[rows[id]]));
  }
  const double scale = 1e9 / slice / static_cast<double>(rows.size()), n = static_cast<double>(rows.size());
  std::printf("%zu grains, %.2f pairs and %.2f bridges each (by hand %.2f, %.2f), %ld and %d lists in %d steps\n",
              rows.size(), static_cast<double>(s.pairs().size()) / n, static_cast<double>(s.bridges().count()) / n,
              static_cast<double>(hand.pairs()) / n, static_cast<double>(hand.bridges()) / n,
              static_cast<long>(s.rebuild_count() - rebuilds), hand.rebuilds() - by_hand, slice * rounds);
  std::printf(
      "library %.1f ns, by hand %.1f ns per grain and step; ratio %.3f (median of %d pairs); largest distance %.2g m\n",
      scale * median(library), scale * median(own), median(ratios), rounds, apart);
}
