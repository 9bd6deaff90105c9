// SPDX-License-Identifier: BSD-3-Clause
// A user's host: two halves of one packing in one process are the packing in one piece, to the last bit.
#include "../catch.hpp"
#include "slabs.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/grain_films.hpp>
#include <pendular/parts.hpp>

#include <cmath>
#include <map>
#include <mutex>

using namespace pendular;

namespace {

constexpr double radius = 0.5e-3;

/// A heap of grains that falls over into an empty box.
template <class Options>
auto heap(const Options& options) {
  using boundary::plane;
  using boundary::wall;
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.3}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}},
                     boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}}, wall{plane{{0, 0, 0}, {1, 0, 0}}},
                                     wall{plane{{20e-3, 0, 0}, {-1, 0, 0}}}, wall{plane{{0, 0, 0}, {0, 1, 0}}},
                                     wall{plane{{0, 4e-3, 0}, {0, -1, 0}}}},
                     velocity_verlet{5e-6, {6, 0, -9.81}}, options};
  for (int k = 0; k < 4 * 4 * 6; ++k) {
    const double shift = 0.1e-3 * (k / 4 % 5);
    s.add({.position = {0.6e-3 + 1.02e-3 * (k % 4) + shift, 0.52e-3 + 0.99e-3 * (k / 4 % 4),
                        0.55e-3 + 1.01e-3 * (k / 16)},
           .radius = radius,
           .density = 2600,
           .velocity = {0.3 * std::sin(k), 0.3 * std::cos(3 * k), 0}});
  }
  return s;
}

struct last_state {
  vector position, velocity, spin;
  double film;
  bool operator==(const last_state&) const = default;
};

template <class System>
void write_down(const System& s, std::map<std::int64_t, last_state>& states) {
  const auto& g = s.particles();
  for (std::size_t row = 0; row < g.kept(); ++row) {
    states[g.template get<column::id>()[row]] = {
        g.template get<column::position>()[row], g.template get<column::velocity>()[row],
        g.template get<column::angular_velocity>()[row], s.bridges().book().films()[row]};
  }
}

/// Films and bridges that are counted here, m3.
template <class System>
double liquid_in(const System& s) {
  const auto& book = s.bridges().book();
  const auto view = s.view();
  double sum = book.keep().reservoir.value();
  for (std::size_t row = 0; row < s.particles().kept(); ++row) sum += book.films()[row];
  view.for_each_row([&](std::size_t p) { sum += view.counts_here(p) ? book.bonds()[p] : 0; });
  return sum;
}

template <class System>
void fall_over(System& s) {
  s.run(200);
  s.distribute_liquid(96 * 1e-12);
  s.run(6000);
}

}  // namespace

TEST_CASE("two halves of a packing are the packing in one piece") {
  auto whole = heap(run_options{.force = true});
  fall_over(whole);
  std::map<std::int64_t, last_state> expected, found;
  write_down(whole, expected);

  // [part]
  slab_house house({4e-3});
  std::mutex one_at_a_time;
  std::int64_t ruptures = 0;
  double liquid = 0;
  in_slabs(house, [&](const slab& half) {
    auto s = heap(run_on{half, {.force = true}});
    fall_over(s);
    const std::lock_guard guard(one_at_a_time);
    write_down(s, found);
    ruptures += s.events().ruptures;
    liquid += liquid_in(s);
  });
  // [/part]
  CHECK(found.size() == 96);
  CHECK(found == expected);
  CHECK(ruptures == whole.events().ruptures);
  CHECK(ruptures > 30);
  CHECK(house.migrations() > 60);
  CHECK(liquid == within(1e-12, 96e-12));
}
