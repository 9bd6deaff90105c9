// SPDX-License-Identifier: BSD-3-Clause
// Parts of a scene when something goes wrong on one of them alone, or nothing is there: all stop, or go on as in one piece.
#include "in_parts.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/system.hpp>

#include <atomic>
#include <stdexcept>

using namespace in_parts;

namespace {

/// A sink that the parts speak about, and that one of them may refuse before they do.
struct picky {
  static constexpr std::string_view account = "vapour";
  std::int64_t period;
  std::int64_t refused;  // id of a grain

  template <class Door>
  void act(Door& door) const {
    door.for_each_grain([&](std::size_t grain) {
      if (door.id(grain) == refused) throw std::runtime_error("not this one");
    });
    const double films = door.sum_over_grains([&](std::size_t grain) { return door.film(grain); });
    const double bridges = door.sum_over_bridges([&](std::size_t pair) { return door.bridge_at(pair).volume; });
    door.for_each_grain(
        [&](std::size_t grain) { door.dry_grain(grain, 1e-3 * door.film(grain) * films / (films + bridges + 1e-20)); });
  }
};

constexpr std::int64_t nobody = -1;

auto grains_of(double stiffness) {
  return material{normal::linear{stiffness}, damping::viscous{0.03}, friction::coulomb_spring{3e3, 0.4}, energy_book{}};
}

template <class Options>
auto dragged(std::int64_t refused, const Options& options) {
  pendular::system s{
      grains_of(4e3),
      liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}, picky{350, refused}},
      dragged_box(), velocity_verlet{dt, sideways}, options};
  fill(s);
  s.run(300);
  s.distribute_liquid(1e-12 * 216);
  return s;
}

/// How many of three parts stop, if each of them does this.
template <class Act>
int stopped(std::int64_t refused, const Act& act) {
  slab_house house({4e-3, 8e-3});
  std::atomic<int> count = 0;
  in_slabs(house, [&](const slab& part) {
    auto s = dragged(refused, run_on{part, {.force = true}});
    try {
      act(s);
    } catch (const std::runtime_error&) {
      ++count;
    }
  });
  return count;
}

template <class System>
bool keeps(const System& s, std::int64_t id) {
  const auto& g = s.particles();
  return g.has_id(id) && g.row_of(id) < g.kept();
}

/// Taking out every fifth grain.
template <class System>
void thin_out(System& s) {
  std::vector<std::int64_t> gone;
  for (std::int64_t id = 0; id < 216; id += 5) gone.push_back(id);
  s.remove(gone);
}

/// What follows from a distribution that would make the scene too soft.
template <class System>
bool is_refused(System& s) {
  s.contact_material() = grains_of(1e-2);
  try {
    s.distribute_liquid(1e-9 * 216);
  } catch (const std::exception&) {
    s.contact_material() = grains_of(4e3);
    return true;
  }
  return false;
}

}  // namespace

TEST_CASE("all parts stop if an observer throws on one of them") {
  const int count = stopped(nobody, [](auto& s) {
    s.run(100, every{10, [](const auto& now) {
                       if (keeps(now, 0)) throw std::runtime_error("seen enough");
                     }});
  });
  CHECK(count == 3);
}

TEST_CASE("all parts stop if a source throws on one of them, before the others ask it for a sum") {
  CHECK(stopped(0, [](auto& s) { s.run(100); }) == 3);
  CHECK(stopped(0, [](auto& s) { s.exchange(picky{1, 0}); }) == 3);
  CHECK(stopped(nobody, [](auto& s) { s.run(100); }) == 0);
}

TEST_CASE("after a refusal all parts go on with their grains where they were") {
  const auto live = [](const auto& options) {
    auto s = dragged(nobody, options);
    s.run(1500);
    if (!is_refused(s)) throw std::logic_error("a limit was not seen");
    s.run(2000);
    return s;
  };
  record whole;
  whole.add(live(run_options{}));
  for (const auto& borders : cuts) {
    slab_house house(borders);
    record parts;
    std::mutex one_at_a_time;
    in_slabs(house, [&](const slab& part) {
      const auto s = live(run_on{part});
      const std::lock_guard guard(one_at_a_time);
      parts.add(s);
    });
    check_same(whole, parts);
  }
}

TEST_CASE("a part without a grain looks at no limits and stops nobody") {
  const auto live = [](const auto& options) {
    auto s = dragged(nobody, options);
    s.run(100);
    return s;
  };
  record whole, parts;
  whole.add(live(run_options{}));
  slab_house house({-1, 6e-3});
  std::mutex one_at_a_time;
  in_slabs(house, [&](const slab& part) {
    const auto s = live(run_on{part});
    const std::lock_guard guard(one_at_a_time);
    parts.add(s);
    if (part.place() == 0) CHECK(s.particles().size() == 0);
  });
  check_same(whole, parts);
}

TEST_CASE("the work of grains that are taken out stays in the energy book of the parts") {
  const auto live = [](const auto& options) {
    auto s = dragged(nobody, options);
    s.run(3000);
    thin_out(s);
    s.run(1000);
    return s;
  };
  const record whole = in_one_piece(live);
  for (const auto& borders : cuts) {
    slab_house house(borders);
    check_same(whole, in_slabs_of(house, live));
  }
}
