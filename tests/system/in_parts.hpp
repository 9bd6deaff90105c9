// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One packing in one piece and in parts: what must be the same, to the last bit.
#include "../open/slabs.hpp"
#include "../physics/scenes.hpp"

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/protocol/one_of.hpp>
#include <pendular/parts.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace in_parts {

using namespace pendular;

constexpr double radius = 0.5e-3, dt = 2.5e-6;

/// Everything that a scene is after a run, by ids; a row of the bonds has two.
struct record {
  using bits = std::vector<std::uint64_t>;  // of doubles: 0 is not -0
  std::map<std::int64_t, bits> grains;
  std::map<std::pair<std::int64_t, std::int64_t>, double> bridges;  // m3
  bits walls;
  std::int64_t ruptures = 0, formations = 0;
  std::int64_t outside = 0;                              // bridges made beyond the validity of their laws
  reproducible_sum liquid, damping, friction, set_free;  // m3, J
  double driven = 0;                                     // work of what drives grains, J
  double here = 0;                                       // m3

  template <class System>
  void add(const System& s) {
    add_grains(s);
    if constexpr (System::wet) add_liquid(s);
    if constexpr (System::material_type::keeps_energy_book) add_work(s);
    driven += s.driven().work();
    walls.clear();
    s.for_each_wall([&](const auto& wall, const auto&) {
      for (const vector& v : {wall.force, wall.shape.point}) put(walls, v);
      put(walls, wall.work);
    });
  }

 private:
  template <class Value>
  static void put(bits& all, const Value& value) {
    if constexpr (std::is_same_v<Value, std::int64_t>) {
      all.push_back(static_cast<std::uint64_t>(value));
    } else {
      for_each_scalar<double>(value, [&](double v) { all.push_back(std::bit_cast<std::uint64_t>(v)); });
    }
  }

  template <class System>
  void add_grains(const System& s) {
    const auto& g = s.particles();
    for (std::size_t row = 0; row < g.kept(); ++row) {
      auto& numbers = grains[g.template get<column::id>()[row]];
      CHECK(numbers.empty());  // nobody else keeps it
      System::grains_type::for_each_column([&](auto column) { put(numbers, g.template get<decltype(column)>()[row]); });
      if constexpr (System::wet) put(numbers, s.bridges().book().films()[row]);
    }
  }

  template <class System>
  void add_liquid(const System& s) {
    const auto view = s.view();
    const auto& book = s.bridges().book();
    view.for_each_row([&](std::size_t p) {
      if (!s.bridges().is_bonded(p)) return;
      const auto known = bridges.emplace(view.ids(p), book.bonds()[p]);
      CHECK(known.first->second == book.bonds()[p]);  // the same on both sides
      if (view.counts_here(p)) liquid.add(book.bonds()[p]);
    });
    for (std::size_t row = 0; row < s.particles().kept(); ++row) liquid.add(book.films()[row]);
    liquid.join(book.keep().reservoir);
    ruptures += s.events().ruptures;
    formations += s.events().formations;
    outside += s.bridges().outside().capillary_law + s.bridges().outside().rupture_law;
    set_free.join(s.bridges().work_sum());
    here = book.introduced();
    for (const auto& account : book.outside()) liquid.join(account.volume);
  }

  template <class System>
  void add_work(const System& s) {
    const auto view = s.view();
    add_sums(s.contacts().work().total([&](std::size_t p) { return view.counts_here(p); }));
    s.for_each_wall([&](const auto&, const auto& contacts) { add_sums(contacts.work().total()); });
  }
  void add_sums(const contact_work& work) { damping.add(work.damping), friction.add(work.friction); }
};

/// Borders of two and of three slabs, m.
const std::vector<std::vector<double>> cuts{{6e-3}, {4e-3, 8e-3}};

/// live(options) makes a scene and runs it, and answers it.
template <class Live>
record in_one_piece(const Live& live) {
  record r;
  r.add(live(run_options{.force = true}));
  return r;
}
template <class Live>
record in_slabs_of(slab_house& house, const Live& live) {
  record r;
  std::mutex one_at_a_time;
  in_slabs(house, [&](const slab& part) {
    const auto s = live(run_on{part, {.force = true}});
    const std::lock_guard guard(one_at_a_time);
    r.add(s);
  });
  return r;
}

inline void check_same(const record& whole, const record& parts) {
  CHECK(parts.grains == whole.grains);
  CHECK(parts.bridges == whole.bridges);
  CHECK(parts.walls == whole.walls);
  CHECK(parts.ruptures == whole.ruptures);
  CHECK(parts.formations == whole.formations);
  CHECK(parts.outside == whole.outside);
  CHECK(parts.here == whole.here);
  CHECK(parts.liquid.value() == within(1e-12, whole.here));
  CHECK(whole.liquid.value() == within(1e-12, whole.here));
  CHECK(parts.damping.value() == within(1e-13, whole.damping.value()));
  CHECK(parts.friction.value() == within(1e-13, whole.friction.value()));
  CHECK(parts.set_free.value() == within(1e-12, whole.set_free.value()));
  CHECK(parts.driven == within(1e-12, whole.driven));
}

template <class Live>
void check_parts(const record& whole, const Live& live) {
  for (const std::vector<double>& borders : cuts) {
    slab_house house(borders);
    check_same(whole, in_slabs_of(house, live));
    CHECK(house.migrations() > 70);
  }
}

constexpr int n = 6;  // grains along an edge of a cube
const vector sideways{4, 0, -9.81};

/// A box of twice the length of the cube of grains, with a floor that drags them along and a lid under a stress.
template <class... Wetting>
auto dragged_box(const Wetting&... wetting) {
  using boundary::fixed;
  constexpr double side = 1.15e-3 * n, top = 1.2e-3 * n;
  using boundary::plane;
  using boundary::wall;
  return boundary::walls{
      wall{plane{{0, 0, 0}, {1, 0, 0}}, fixed{}, none{}, wetting...},
      wall{plane{{2 * side, 0, 0}, {-1, 0, 0}}},
      wall{plane{{0, 0, 0}, {0, 1, 0}}},
      wall{plane{{0, side, 0}, {0, -1, 0}}},
      wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0.1, 0, 0}}, none{}, wetting...},
      wall{plane{{0, 0, top}, {0, 0, -1}}, boundary::servo_stress{20, 2 * side * side, 1e-5, 1e-3}, none{},
           wetting...}};
}

/// Grains of two sizes that fly about, so that bridges break and form all the time and grains leave their slabs.
template <class System>
void fill(System& s) {
  for (grain g : scenes::loose_lattice(n, n, n, radius, 0.1, 1.15e-3, 0.2)) {
    const double k = static_cast<double>(s.particles().next_id());
    g.velocity = {std::sin(k), std::cos(2 * k), std::sin(5 * k)};
    s.add(g);
  }
}

}  // namespace in_parts
