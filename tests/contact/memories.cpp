// SPDX-License-Identifier: BSD-3-Clause
// Several policies of one material that remember, written as a user would: each finds its own memory again, at pairs and
// at walls, of unequal masses, in a new list and after a resume.
#include "../catch.hpp"

#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/law/damping/clamped.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <filesystem>
#include <type_traits>

using namespace pendular;

namespace {

/// Stiffer on unloading than on loading, by the deepest overlap of the contact (Walton and Braun 1986): restitution
/// sqrt(loading / unloading) at any speed.
struct plastic_spring {
  double loading, unloading;  // N/m

  template <class T>
  struct contact_memory {
    T deepest;  // m
  };

  template <Scalar T>
  T repulsion(const approach<T>& a, contact_memory<T>& memory) const {
    const T overlap = max(T(-a.gap), T(0));
    memory.deepest = unit_step(overlap) * max(memory.deepest, overlap);
    const T left = memory.deepest * T(1 - loading / unloading);
    const T force = min(T(T(loading) * overlap), T(T(unloading) * (overlap - left)));
    return max(force, T(0));
  }
};

/// A dashpot that knows how fast its contact closed at most.
struct remembering_dashpot {
  double coefficient;  // N s2/m2

  template <class T>
  struct contact_memory {
    T fastest;         // m/s
    Vec3<T> followed;  // along with the contact
  };

  template <Scalar T>
  T resistance(const approach<T>& a, const T&, contact_memory<T>& memory) const {
    const T touching = unit_step(T(-a.gap));
    memory.fastest = touching * max(memory.fastest, a.closing_speed);
    return touching * T(coefficient) * memory.fastest * a.closing_speed;
  }
};

static_assert(check::normal_law<plastic_spring> && check::damping_law<remembering_dashpot>);
static_assert(check::damping_law<damping::clamped<remembering_dashpot>>);

using slider = friction::coulomb_spring;
using all_three = material<slider, plastic_spring, remembering_dashpot>;
template <class Material>
inline constexpr std::size_t numbers = scalar_table<Material::template memory>::width;

// One that remembers has its own record, as if it were alone; several lie side by side, and nothing between them.
static_assert(std::is_same_v<material<normal::linear, slider>::memory<double>, slider::contact_memory<double>>);
static_assert(std::is_same_v<material<remembering_dashpot, normal::linear>::memory<block>,
                             remembering_dashpot::contact_memory<block>>);
static_assert(std::is_same_v<material<damping::clamped<remembering_dashpot>, normal::linear>::memory<double>,
                             remembering_dashpot::contact_memory<double>>);
static_assert(numbers<all_three> == 3 + 1 + 4 && sizeof(all_three::memory<double>) == 8 * sizeof(double));
static_assert(numbers<material<plastic_spring, slider>> == 4 && numbers<material<slider, plastic_spring>> == 4);
static_assert(std::is_empty_v<material<normal::linear, damping::clamped<damping::viscous>>::memory<block>>);
static_assert(all_three::has_memory && !material<normal::linear, damping::viscous>::has_memory);

constexpr double r = 0.5e-3, rho = 2600;

template <class Material, class Walls>
auto scene(const Material& m, const Walls& walls) {
  return pendular::system{m, walls, velocity_verlet{1e-7}, run_options{.force = true}};
}
auto floor_at_0() { return boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}}; }

/// Restitution of grains of unequal size that meet head on along x.
template <class Material>
double pair_restitution(const Material& m, double speed) {
  auto s = scene(m, boundary::walls{});
  s.add({{0, 0, 0}, r, rho, {speed, 0, 0}});
  s.add({{3 * r + 1e-9, 0, 0}, 2 * r, rho, {0, 0, 0}});
  s.run(4000);
  const auto v = s.particles().template get<column::velocity>();
  const auto rows = s.particles().rows_by_id();
  REQUIRE(v[rows[1]].x > v[rows[0]].x);
  return (v[rows[1]].x - v[rows[0]].x) / speed;
}
template <class Material>
double wall_restitution(const Material& m, double speed) {
  auto s = scene(m, floor_at_0());
  s.add({{0, 0, r + 1e-9}, r, rho, {0, 0, -speed}});
  s.run(4000);
  const double after = s.particles().template get<column::velocity>()[0].z;
  REQUIRE(after > 0);
  return after / speed;
}

}  // namespace

TEST_CASE("a normal law that remembers unloads along another line, at pairs and walls") {
  // sqrt(500/800) = 0.790569; the stored part of the work is 1/2 F^2 over the unloading stiffness
  const plastic_spring spring{500, 800};
  for (const double speed : {0.02, 0.1}) {
    CHECK(pair_restitution(material{spring}, speed) == near(1e-3, 0.790569));
    CHECK(wall_restitution(material{spring}, speed) == near(1e-3, 0.790569));
  }
}

TEST_CASE("a second impact begins with an empty memory") {
  auto s = scene(material{plastic_spring{500, 800}}, floor_at_0());
  s.add({{0, 0, r + 1e-9}, r, rho, {0, 0, -0.1}});
  s.run(4000);
  auto velocity = s.particles().get<column::velocity>();
  velocity[0].z = -0.1;
  s.run(4000 + 8000);
  CHECK(s.particles().get<column::velocity>()[0].z / 0.1 == near(1e-3, 0.790569));
}

TEST_CASE("policies that remember do not see each other's memories, in any order") {
  const plastic_spring spring{500, 800};
  const remembering_dashpot dashpot{0.02};
  const slider rough{800, 0.4};
  const double one = pair_restitution(material{spring, dashpot}, 0.05);
  const double at_wall = wall_restitution(material{spring, dashpot}, 0.05);
  CHECK(one < 0.79);
  CHECK(at_wall < 0.79);
  // head on nothing slips: friction changes nothing but the place of the memories
  CHECK(pair_restitution(material{rough, spring, dashpot}, 0.05) == within(1e-9, one));
  CHECK(pair_restitution(material{dashpot, rough, spring}, 0.05) == within(1e-9, one));
  CHECK(wall_restitution(material{rough, dashpot, spring}, 0.05) == within(1e-9, at_wall));
  CHECK(wall_restitution(material{spring, rough, dashpot}, 0.05) == within(1e-9, at_wall));
}

TEST_CASE("a friction spring beside a dashpot that remembers is the spring alone") {
  // a dashpot of coefficient 0 remembers and does nothing
  const auto slide = [](const auto& m) {
    auto s = scene(m, floor_at_0());
    s.add({{0, 0, r - 1e-6}, r, rho, {0.01, 0.02, 0}});
    s.add({{2 * r - 1e-6, 0, r - 1e-6}, r, rho, {0, 0.01, 0}});
    s.run(500);
    return s;
  };
  const auto alone = slide(material{normal::linear{1e3}, slider{800, 0.4}});
  const auto beside = slide(material{remembering_dashpot{0}, normal::linear{1e3}, slider{800, 0.4}});
  const auto v = alone.particles().get<column::velocity>(), w = beside.particles().get<column::velocity>();
  const auto spin = alone.particles().get<column::angular_velocity>();
  const auto turned = beside.particles().get<column::angular_velocity>();
  for (std::size_t k = 0; k < 2; ++k) CHECK((v[k] == w[k] && spin[k] == turned[k] && norm(spin[k]) > 0));
}

TEST_CASE("the stiffness of a law that remembers is that of its branch") {
  const plastic_spring law{500, 800};
  const approach<double> a{-1e-6, 0, 1e-6, r, r};
  const plastic_spring::contact_memory<double> fresh{0}, pressed{1.1e-6};
  CHECK(stiffness(law, a) == within(1e-12, 500));
  CHECK(stiffness(law, a, fresh) == within(1e-12, 500));
  CHECK(stiffness(law, a, pressed) == within(1e-12, 800));
  const plastic_spring::contact_memory<block> lanes{block::from([](int k) { return k < 4 ? 0 : 1.1e-6; })};
  const approach<block> many{block(-1e-6), block(0), block(1e-6), block(r), block(r)};
  const block found = stiffness(law, many, lanes);
  CHECK(found[0] == within(1e-12, 500));
  CHECK(found[7] == within(1e-12, 800));
  CHECK(pressed.deepest == 1.1e-6);
}

TEST_CASE("vectors of every memory follow the contact, those of members too") {
  struct inner {
    vector arrow;
    double number;
  };
  struct outer {
    double number;
    inner nested;
    vector arrow;
  };
  outer memory{7, {{3, 0, 4}, 8}, {0, 0, 2}};
  detail::follow_all(memory, vector{0, 0, 1}, 0.0);
  CHECK(memory.nested.arrow.x == within(1e-14, 5));
  CHECK(memory.nested.arrow.z == 0);
  CHECK((memory.number == 7 && memory.nested.number == 8));
}

TEST_CASE("a resumed scene has all memories again") {
  const material m{remembering_dashpot{0.02}, slider{800, 0.4}, plastic_spring{500, 800}};
  auto s = scene(m, floor_at_0());
  s.add({{0, 0, r - 1e-7}, r, rho, {0.03, 0, -0.05}});
  s.add({{2 * r - 1e-7, 0, r + 1e-7}, r, rho, {-0.03, 0.02, -0.05}});
  s.run(150);
  s.canonicalise();
  const auto file = std::filesystem::temp_directory_path() / "pendular_memories.checkpoint";
  {
    io::checkpoint_writer out{file};
    io::save(out, s);
    out.commit();
  }
  auto again = scene(m, floor_at_0());
  const io::checkpoint_reader in{file};
  io::load(in, again);
  std::filesystem::remove(file);
  s.run(300);
  again.run(300);
  const auto v = s.particles().get<column::velocity>(), w = again.particles().get<column::velocity>();
  for (std::size_t k = 0; k < 2; ++k) CHECK(v[k] == w[k]);
}
