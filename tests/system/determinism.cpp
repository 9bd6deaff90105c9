// SPDX-License-Identifier: BSD-3-Clause

// What must not change a single bit: threads, the skin of the list, a liquid policy without liquid, a restart.
#include "../physics/scenes.hpp"

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/rupture/willett.hpp>

#include <cstdlib>
#include <cstring>
#include <filesystem>

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pendular;
using namespace scenes;

namespace {

const vector gravity_down{0, 0, -9.81};
constexpr double added_liquid = 1e-2 * 0.125e-9 * 300;  // m3, some 300 bridges of 0.01 R^3
const material rubbing{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}};
const material creeping{normal::linear{1e3}, damping::viscous{0.3}, friction::viscous_coulomb{1, 0.4}, energy_book{}};

template <class Protocol>
auto water_with(const Protocol& p) {
  return liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, p};
}

/// A floor moving along x, a lid pressed down by a stress, four side walls.
auto moving_cell(double side, double top) {
  using boundary::plane;
  using boundary::wall;
  return boundary::walls{wall{plane{{0, 0, 0}, {1, 0, 0}}},
                         wall{plane{{side, 0, 0}, {-1, 0, 0}}},
                         wall{plane{{0, 0, 0}, {0, 1, 0}}},
                         wall{plane{{0, side, 0}, {0, -1, 0}}},
                         wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0.05, 0, 0}}},
                         wall{plane{{0, 0, top}, {0, 0, -1}}, boundary::servo_stress{50, side * side, 1e-5, 1e-3}}};
}

/// The same, wet at the floor, the lid and one side.
auto wet_cell(double side, double top) {
  using boundary::plane;
  using boundary::wall;
  const boundary::wettable wet;
  return boundary::walls{
      wall{plane{{0, 0, 0}, {1, 0, 0}}, boundary::fixed{}, none{}, wet},
      wall{plane{{side, 0, 0}, {-1, 0, 0}}},
      wall{plane{{0, 0, 0}, {0, 1, 0}}},
      wall{plane{{0, side, 0}, {0, -1, 0}}},
      wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0.05, 0, 0}}, none{}, wet},
      wall{plane{{0, 0, top}, {0, 0, -1}}, boundary::servo_stress{50, side * side, 1e-5, 1e-3}, none{}, wet}};
}

/// All that moves, in the order of ids.
template <class System>
std::vector<double> fingerprint(const System& s) {
  std::vector<double> all;
  const auto put = [&](const vector& v) { all.insert(all.end(), {v.x, v.y, v.z}); };
  for (const std::size_t row : s.particles().rows_by_id()) {
    put(s.particles().template get<column::position>()[row]);
    put(s.particles().template get<column::velocity>()[row]);
    put(s.particles().template get<column::force>()[row]);
    if constexpr (System::grains_type::rotate) put(s.particles().template get<column::angular_velocity>()[row]);
    if constexpr (System::wet) all.push_back(s.bridges().book().films()[row]);
  }
  if constexpr (System::wet) {
    all.push_back(static_cast<double>(s.bridges().count()));
    all.push_back(static_cast<double>(s.events().ruptures));
    all.push_back(static_cast<double>(s.events().formations));
  }
  s.for_each_wall([&](const auto& wall, const auto&) { put(wall.force), put(wall.shape.point); });
  return all;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

template <class Material, class Protocol, class Integration = velocity_verlet>
auto wet_scene(const Material& m, const Protocol& p, std::optional<double> skin, int n = 6, double time_step = 5e-6) {
  pendular::system s{m, water_with(p), moving_cell(1.2e-3 * n, 1.22e-3 * n), Integration{time_step, gravity_down},
                     run_options{.skin = skin, .force = true}};
  for (const grain& g : loose_lattice(n, n, n, 0.5e-3, 0.1, 1.2e-3, 0.2)) s.add(g);
  return s;
}

template <class Protocol>
auto wet_walled_scene(const Protocol& p, std::optional<double> skin, int n = 6) {
  pendular::system s{rubbing, liquid{fluid::water(), capillary::bagheri{}, rupture::willett{}, p},
                     wet_cell(1.2e-3 * n, 1.22e-3 * n), velocity_verlet{5e-6, gravity_down},
                     run_options{.skin = skin, .force = true}};
  for (const grain& g : loose_lattice(n, n, n, 0.5e-3, 0.1, 1.2e-3, 0.2)) s.add(g);
  return s;
}

/// A grain of five times the radius of the others, in their middle.
template <class Protocol>
auto graded_scene(const Protocol& p, std::optional<double> skin, int n = 8) {
  const double side = 1.2e-3 * n, large = 2.5e-3;
  const vector middle{0.5 * side, 0.5 * side, 0.5 * side};
  pendular::system s{rubbing, water_with(p), moving_cell(side, 1.22e-3 * n), velocity_verlet{5e-6, gravity_down},
                     run_options{.skin = skin, .force = true}};
  for (const grain& g : loose_lattice(n, n, n, 0.5e-3, 0.1, 1.2e-3, 0.2)) {
    if (s.particles().size() == 100) s.add({middle, large, 2600});
    if (norm(g.position - middle) > large + g.radius) s.add(g);
  }
  CHECK(size_classes(s.particles().template get<column::radius>(), 0).all().size() == 2);
  return s;
}

template <class System>
void wet_and_run(System& s, std::int64_t steps, const bond_selection& selection = {}) {
  s.run(1000);
  s.distribute_liquid(added_liquid, selection);
  s.run(steps);
}

/// So many threads for as long as it lives. One is the rule here: two that wait for each other on busy cores take long.
class threads {
 public:
#ifdef _OPENMP
  explicit threads(int n) : before_(omp_get_max_threads()) { omp_set_num_threads(n); }
  ~threads() { omp_set_num_threads(before_); }
#else
  explicit threads(int) {}
#endif
  threads(const threads&) = delete;
  threads& operator=(const threads&) = delete;

 private:
  [[maybe_unused]] int before_ = 1;
};

}  // namespace

#ifdef _OPENMP
TEST_CASE("one and two threads give the same bits, energy book included") {
  const auto run = [](int count, auto s, const bond_selection& selection) {
    const threads some(count);
    s.run(300);
    s.distribute_liquid(added_liquid, selection);
    s.run(300);
    auto f = fingerprint(s);
    f.push_back(observe::energies_of(s).balance());
    CHECK(s.bridges().count() > 100);
    return f;
  };
  const auto check = [&](const auto& s, const bond_selection& selection = {}) {
    CHECK(same_bits(run(1, s, selection), run(2, s, selection)));
  };
  const int side = 9;  // 729 grains: more than one chunk of every kind
  check(wet_scene(rubbing, protocol::grain_films{}, 0.2, side));
  check(wet_scene(creeping, protocol::homogeneous{200}, 0.2, side));
  check(wet_walled_scene(protocol::neighbours{}, 0.2, side));
  check(graded_scene(protocol::grain_films{}, 0.2, side));
  const bond_selection some{.thinning = 1.2, .seed = 3, .widest_gap = 5e-5, .film_thickness = 5e-8};
  check(wet_scene(creeping, protocol::homogeneous{200}, 0.2, side), some);
  check(wet_walled_scene(protocol::grain_films{}, 0.2, side), some);
}
#endif

TEST_CASE("a list made anew at every step and one that lasts give the same bits") {
  const threads one(1);
  const auto check = [](const auto& scene_with_skin) {
    auto each_step = scene_with_skin(0.2), wide = scene_with_skin(0.9), usual = scene_with_skin(0.2);
    wet_and_run(usual, 1500);
    wet_and_run(wide, 1500);
    each_step.run(1000);
    each_step.distribute_liquid(added_liquid);
    for (int n = 0; n < 1500; ++n) {
      each_step.canonicalise();
      each_step.run(1);
    }
    CHECK(wide.rebuild_count() < usual.rebuild_count());
    CHECK(wide.events().ruptures > 10);
    CHECK(same_bits(fingerprint(usual), fingerprint(wide)));
    CHECK(same_bits(fingerprint(usual), fingerprint(each_step)));
  };
  check([](double skin) { return wet_scene(rubbing, protocol::grain_films{}, skin, 5); });
  check([](double skin) { return wet_scene(creeping, protocol::gravity{}, skin, 5); });
  check([](double skin) { return wet_scene(rubbing, protocol::neighbours{}, skin, 5); });
  check([](double skin) { return wet_walled_scene(protocol::grain_films{}, skin, 5); });
  check([](double skin) { return graded_scene(protocol::neighbours{}, skin, 6); });
  check([](double skin) { return wet_walled_scene(protocol::gravity{}, skin, 5); });
  check([](double skin) { return wet_scene(rubbing, protocol::homogeneous{100}, skin, 5); });
}

TEST_CASE("a skin thinner than a step's way only costs time") {
  const threads one(1);
  auto thin = wet_scene(rubbing, protocol::grain_films{}, 1e-9, 4),
       usual = wet_scene(rubbing, protocol::grain_films{}, 0.2, 4);
  wet_and_run(usual, 1000);
  REQUIRE(usual.events().ruptures > 0);
  CHECK_NOTHROW(wet_and_run(thin, 1000));
  CHECK(thin.rebuild_count() > 1900);
  CHECK(same_bits(fingerprint(thin), fingerprint(usual)));
}

TEST_CASE("a formation rule with a reach does not depend on the skin either") {
  const threads one(1);
  const auto run = [](double skin) {
    pendular::system s{rubbing,
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{},
                              formation::within_rupture_distance{}},
                       moving_cell(7.2e-3, 7.32e-3), velocity_verlet{5e-6, gravity_down},
                       run_options{.skin = skin, .force = true}};
    for (const grain& g : loose_lattice(6, 6, 6, 0.5e-3, 0.1, 1.2e-3, 0.2)) s.add(g);
    wet_and_run(s, 2000);
    CHECK(s.events().ruptures > 10);
    return fingerprint(s);
  };
  const auto usual = run(0.2);
  CHECK(same_bits(usual, run(0.9)));
  CHECK(same_bits(usual, run(0.02)));
}

TEST_CASE("a wet composition without liquid moves as the dry one to the last bit") {
  const threads one(1);
  const double n = 6;
  auto wet = wet_scene(rubbing, protocol::grain_films{}, 0.2);
  pendular::system dried{rubbing, moving_cell(1.2e-3 * n, 1.22e-3 * n), velocity_verlet{5e-6, gravity_down},
                         run_options{.skin = 0.2, .force = true}};
  for (const grain& g : loose_lattice(6, 6, 6, 0.5e-3, 0.1, 1.2e-3, 0.2)) dried.add(g);
  wet.run(3000);
  dried.run(3000);
  for (std::int64_t id = 0; id < 216; ++id) {
    REQUIRE(position(wet, id) == position(dried, id));
    REQUIRE(spin(wet, id) == spin(dried, id));
  }
}

TEST_CASE("putting in a volume of nothing before the first step changes no bit") {
  const threads one(1);
  auto wet = wet_scene(rubbing, protocol::grain_films{}, 0.2, 4),
       never = wet_scene(rubbing, protocol::grain_films{}, 0.2, 4);
  wet.distribute_liquid(0);
  wet.run(2000);
  never.run(2000);
  CHECK(same_bits(fingerprint(wet), fingerprint(never)));
}

TEST_CASE("putting in no liquid in the middle of a run moves no friction spring and books no loss") {
  const threads one(1);
  auto s = wet_scene(rubbing, protocol::grain_films{}, 0.2, 4);
  wet_and_run(s, 500);
  const auto before = observe::energies_of(s);
  s.distribute_liquid(0);
  CHECK(observe::energies_of(s).friction == before.friction);
  CHECK(observe::energies_of(s).friction_springs == before.friction_springs);
  CHECK(observe::energies_of(s).damping == before.damping);
}

TEST_CASE("the order in which grains are added does not change the physics") {
  const threads one(1);
  const auto run = [](bool backwards) {
    pendular::system s{creeping, water_with(protocol::grain_films{}), moving_cell(4.8e-3, 4.88e-3),
                       velocity_verlet{2e-6, gravity_down}, run_options{.force = true}};
    auto all = loose_lattice(4, 4, 4, 0.5e-3, 0.1, 1.2e-3, 0.2);
    if (backwards) std::reverse(all.begin(), all.end());
    for (const grain& g : all) s.add(g);
    s.run(1000);
    s.distribute_liquid(1e-2 * 0.125e-9 * 100);
    s.run(1500);
    return s;
  };
  auto forth = run(false), back = run(true);
  CHECK(forth.bridges().count() > 30);
  CHECK(forth.bridges().count() == back.bridges().count());
  CHECK(forth.events().ruptures == back.events().ruptures);
  double worst = 0;
  for (std::int64_t id = 0; id < 64; ++id) worst = std::max(worst, norm(position(forth, id) - position(back, 63 - id)));
  CHECK(worst < 1e-11);  // sums in another order, and chaos
}

namespace {
/// Runs on from a checkpoint in a new system, beside the run that wrote it.
template <class Make>
void check_restart(const Make& make, const bond_selection& selection = {}) {
  const auto folder = std::filesystem::temp_directory_path() / ("pendular_restart_" + std::to_string(std::rand()));
  std::filesystem::create_directories(folder);
  auto first = make();
  wet_and_run(first, 1000, selection);
  first.canonicalise();
  {
    io::checkpoint_writer out(folder / "state");
    io::save(out, first);
    out.commit();
  }
  first.run(700);
  auto second = make();
  {
    // A new scene of the same composition, without grains and with its lid elsewhere.
    auto walls = second.walls();
    boundary::get<5>(walls).shape.point.z = 1;
    pendular::system fresh{second.contact_material(), second.bridges().policies(), walls, second.integrator(),
                           run_options{.force = true}};
    io::load(io::checkpoint_reader(folder / "state"), fresh);
    CHECK(fresh.step_count() == first.step_count() - 700);
    fresh.run(700);
    CHECK(same_bits(fingerprint(first), fingerprint(fresh)));
    CHECK(observe::energies_of(first).balance() == observe::energies_of(fresh).balance());
    CHECK(observe::energies_of(first).friction == observe::energies_of(fresh).friction);
    CHECK(first.bridges().book().total() == fresh.bridges().book().total());
    // A second generation must agree as well.
    first.canonicalise();
    fresh.canonicalise();
    first.run(300);
    fresh.run(300);
    CHECK(same_bits(fingerprint(first), fingerprint(fresh)));
  }
  CHECK(first.events().ruptures > 5);
  std::filesystem::remove_all(folder);
}
}  // namespace

TEST_CASE("a resumed run goes on with the same bits") {
  const threads one(1);
  SECTION("friction springs and films") {
    check_restart([] { return wet_scene(rubbing, protocol::grain_films{}, {}); });
  }
  SECTION("viscous friction and homogeneous redistribution") {
    check_restart([] { return wet_scene(creeping, protocol::homogeneous{150}, {}); });
  }
  SECTION("close pairs only, films held by the grains") {
    const bond_selection selection{.thinning = 1.2, .seed = 3, .widest_gap = 5e-5, .film_thickness = 5e-7};
    check_restart([] { return wet_scene(rubbing, protocol::homogeneous{150}, {}); }, selection);
    check_restart([] { return wet_scene(rubbing, protocol::grain_films{}, {}); }, selection);
  }
  SECTION("a large grain") {
    check_restart([] { return graded_scene(protocol::neighbours{}, {}); });
  }
  SECTION("bridges at walls") {
    check_restart([] { return wet_walled_scene(protocol::grain_films{}, {}); });
  }
  SECTION("bridges at walls, films held by the grains") {
    check_restart([] { return wet_walled_scene(protocol::neighbours{}, {}); }, {.film_thickness = 5e-7});
  }
  SECTION("half-step velocities and gravity") {
    check_restart([] {
      return wet_scene<decltype(rubbing), protocol::gravity, half_step_velocity_verlet>(rubbing, protocol::gravity{},
                                                                                        {});
    });
  }
}
