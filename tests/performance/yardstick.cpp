// SPDX-License-Identifier: BSD-3-Clause
// The library's scenes against the same scenes written by hand, in turns: time per grain and step, and how far apart the
// grains end. By hand there are two of each: in two phases as the library has them, which threads could share, and with
// every force straight to its grains, which one thread only may do.
#include "median.hpp"
#include "packing.hpp"
#include "stopwatch.hpp"
#include "yardstick/dry.hpp"
#include "yardstick/smooth.hpp"
#include "yardstick/wet.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/none.hpp>

#include <algorithm>
#include <string>

using namespace pendular;

namespace {
constexpr int rounds = 9;
const yardstick::parameters p;
const velocity_verlet integrator{p.time_step, {0, 0, p.gravity}};
const run_options options{.skin = p.skin};  // the same lists on both sides

template <class System>
double distance(const System& s, const yardstick::box& by_hand) {
  const auto x = by_hand.positions_by_id();
  const auto rows = s.particles().rows_by_id();
  double apart = 0;
  for (std::size_t id = 0; id < rows.size(); ++id)
    apart = std::max(apart, norm(x[id] - s.particles().template get<column::position>()[rows[id]]));
  return apart;
}

/// Takes copies, so that the next comparison begins where this one did.
template <class System, class Hand>
void compare(const std::string& name, System s, Hand hand, int slice) {
  const auto relisted = s.rebuild_count();
  const int by_hand = hand.room().relisted;
  std::vector<double> ratios, library, own;
  for (int round = 0; round < rounds; ++round) {
    library.push_back(timed([&] { s.run(slice); }));
    own.push_back(timed([&] { hand.run(slice); }));
    ratios.push_back(library.back() / own.back());
  }
  const double n = static_cast<double>(s.particles().size()), scale = 1e9 / slice / n;
  std::printf("%-17s pairs %.2f (by hand %.2f), lists %ld (%d), library %6.1f ns, by hand %6.1f ns per grain and step; "
              "ratio %.3f, at most %.2g m apart\n",
              name.c_str(), static_cast<double>(s.pairs().size()) / n, static_cast<double>(hand.room().pairs.count) / n,
              static_cast<long>(s.rebuild_count() - relisted), hand.room().relisted - by_hand, scale * median(library),
              scale * median(own), median(ratios), distance(s, hand.room()));
  if constexpr (System::wet)
    std::printf("%-17s bridges %.2f (by hand %.2f)\n", "", static_cast<double>(s.bridges().count()) / n,
                static_cast<double>(hand.bridges()) / n);
}

template <class System>
void fill(System& s, const packing::sample& sample) {
  for (const grain& g : sample.grains) s.add(g);
  s.start();
}

void smooth(const packing::sample& sample, int slice) {
  pendular::system s{material{normal::linear{p.stiffness}, damping::viscous{p.damping}},
                     packing::box_of(sample.size, boundary::fixed{}), integrator, options};
  fill(s, sample);
  using namespace yardstick;
  compare("smooth", s, smooth_scene<listed_forces>(sample.grains, sample.size, p), slice);
  compare("smooth, straight", s, smooth_scene<straight_forces>(sample.grains, sample.size, p), slice);
}

void dry_spring(const packing::sample& sample, int slice) {
  using namespace yardstick;
  using listed = dry_scene<listed_actions>;
  pendular::system s{material{normal::linear{p.stiffness}, damping::viscous{p.damping},
                              friction::coulomb_spring{listed::tangential_stiffness, p.friction}},
                     packing::box_of(sample.size, boundary::fixed{}), integrator, options};
  fill(s, sample);
  compare("dry", s, listed(sample.grains, sample.size, p), slice);
  compare("dry, straight", s, dry_scene<straight_actions>(sample.grains, sample.size, p), slice);
}

void wet(const packing::sample& sample, int slice) {
  using namespace yardstick;
  using listed = wet_scene<listed_actions>;
  const liquid water{fluid{listed::kappa / (2 * std::numbers::pi), 0, 1000, 1e-3}, capillary::richefeu{},
                     rupture::lian{}};
  pendular::system s{material{normal::linear{p.stiffness}, damping::viscous{p.damping},
                              friction::viscous_coulomb{listed::viscosity, p.friction}},
                     water, packing::box_of(sample.size, boundary::fixed{}), integrator, options};
  fill(s, sample);
  double mass = 0;
  for (const double inverse : s.particles().get<column::inverse_mass>()) mass += 1 / inverse;
  s.distribute_liquid(0.01 * mass / 1000);
  const auto view = s.view();
  std::set<std::pair<std::int64_t, std::int64_t>> bridges;
  double alpha = 0;
  for (std::size_t k = 0; k < view.pairs; ++k) {
    if (!s.bridges().is_bonded(k)) continue;
    bridges.insert(view.ids(k));
    alpha = s.bridges().book().bonds()[k] / bond_size(view.bridge_of(k, 0, 0));
  }
  compare("wet", s, listed(sample.grains, sample.size, p, alpha, bridges), slice);
  compare("wet, straight", s, wet_scene<straight_actions>(sample.grains, sample.size, p, alpha, bridges), slice);
}
}  // namespace

int main(int count, char** arguments) {
  const std::size_t grains = count > 1 ? std::stoul(arguments[1]) : 8000;
  const int slice = count > 2 ? std::stoi(arguments[2]) : 200;
  const std::string only = count > 3 ? arguments[3] : "";
  const auto sample = packing::of_size(packing::block("packing_8000.bin"), grains);
  std::printf("%zu grains, %d steps; ratio: library / by hand, median of %d pairs of %d steps\n", sample.grains.size(),
              slice * rounds, rounds, slice);
  if (only.empty() || only == "wet") wet(sample, slice);
  if (only.empty() || only == "dry") dry_spring(sample, slice);
  if (only.empty() || only == "smooth") smooth(sample, slice);
}
