// SPDX-License-Identifier: BSD-3-Clause
// What is done to a scene between runs: grains added, liquid put in or refused, films put on. Whoever is not concerned goes
// on with the same bits.
#include "../physics/scenes.hpp"

#include <pendular/boundary/turning.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/liquid/source/evaporation.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/fabric.hpp>
#include <pendular/observe/grain_pressures.hpp>
#include <pendular/observe/stress.hpp>

#include <range/v3/view/filter.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace pendular;
using namespace scenes;

namespace {

constexpr double radius = 0.5e-3;

enum class meanwhile { nothing, far_grain_once, far_grain_often, far_pair, no_liquid, list_anew };

/// A pair collides off centre, and one grain hits the floor, while something is done that does not concern them.
template <class Integration>
auto collision(meanwhile what) {
  const double v = 0.05, k = 1e3, m = sphere_mass(radius, 2600), dt = pi * std::sqrt(m / 2 / k) / 50;
  pendular::system s{
      material{normal::linear{k}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}},
      liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}}, floor_plane(), Integration{dt},
      run_options{.force = true}};
  s.add({.position = {0, 0, 5e-3}, .radius = radius, .density = 2600, .velocity = {v, 0, 0}});
  s.add(
      {.position = {2 * radius + 0.5 * v * dt, 0, 5.1e-3}, .radius = radius, .density = 2600, .velocity = {-v, 0, 0}});
  s.add({.position = {-9e-3, 0, radius + 0.5 * v * dt}, .radius = radius, .density = 2600, .velocity = {0.02, 0, -v}});
  s.start();
  for (int step = 1; step <= 120; ++step) {
    s.run(1);
    const double y = 0.05 + 0.002 * step;
    if (what == meanwhile::far_grain_once && step == 25)
      s.add({.position = {0, y, 5e-3}, .radius = radius, .density = 2600});
    if (what == meanwhile::far_grain_often) s.add({.position = {0, y, 5e-3}, .radius = radius, .density = 2600});
    if (what == meanwhile::far_pair && step % 10 == 0) {  // listed beside the pair that collides
      for (const double x : {0.0, 2.01 * radius}) s.add({.position = {x, y, 5e-3}, .radius = radius, .density = 2600});
    }
    if (what == meanwhile::no_liquid && step % 10 == 0) s.distribute_liquid(0);
    if (what == meanwhile::list_anew && step % 10 == 0) s.canonicalise();
  }
  s.start();
  return s;
}

template <class Integration>
void expect_undisturbed() {
  const auto alone = collision<Integration>(meanwhile::nothing);
  for (const meanwhile what : {meanwhile::far_grain_once, meanwhile::far_grain_often, meanwhile::far_pair,
                               meanwhile::no_liquid, meanwhile::list_anew}) {
    const auto s = collision<Integration>(what);
    for (const std::int64_t id : {0, 1, 2}) {
      const grain a = alone.particles()[row_of(alone, id)], b = s.particles()[row_of(s, id)];
      CHECK((a.position == b.position && a.velocity == b.velocity && a.angular_velocity == b.angular_velocity));
    }
    const auto before = observe::energies_of(alone), after = observe::energies_of(s);
    CHECK((before.damping == within(1e-14, after.damping) && before.friction == within(1e-14, after.friction)));
  }
}

template <class Protocol>
auto two_far_grains(double gap, double speed, const Protocol& protocol, double skin) {
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol}, boundary::walls{},
                     half_step_velocity_verlet{1e-6}, run_options{.skin = skin}};
  s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  s.add({.position = {0, 0, 2 * radius + gap}, .radius = radius, .density = 2600, .velocity = {0, 0, -speed}});
  s.run(10);
  return s;
}

}  // namespace

TEST_CASE("collisions do not know what is done to the scene elsewhere") {
  expect_undisturbed<half_step_velocity_verlet>();
  expect_undisturbed<velocity_verlet>();
}

TEST_CASE("a grain put in touching another pushes it from the next step on") {
  pendular::system s{material{normal::linear{1e3}}, floor_plane(), velocity_verlet{1e-7}};
  s.add({.position = {0, 0, 5e-3}, .radius = radius, .density = 2600});
  s.run(10);
  s.add({.position = {2 * radius - 1e-7, 0, 5e-3}, .radius = radius, .density = 2600});
  s.start();
  CHECK(s.contacts().force(0).x == within(1e-6, -1e3 * 1e-7));
  s.run(1);
  CHECK(velocity(s, 0).x == within(1e-3, -1e-4 / sphere_mass(radius, 2600) * 1e-7));
}

TEST_CASE("a grain put in touching another pushes it also if a list was made before its forces were known") {
  pendular::system s{material{normal::linear{1e3}}, floor_plane(), velocity_verlet{1e-7}};
  s.add({.position = {0, 0, 5e-3}, .radius = radius, .density = 2600});
  s.run(10);
  s.add({.position = {2 * radius - 1e-7, 0, 5e-3}, .radius = radius, .density = 2600});
  s.canonicalise();
  s.start();
  CHECK(s.contacts().force(0).x == within(1e-6, -1e3 * 1e-7));
}

TEST_CASE("liquid that a limit refuses is not in, and the scene goes on as if nobody had asked") {
  const auto make = [] {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}},
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}}, boundary::walls{},
                       velocity_verlet{1e-5}};
    s.add({.position = {0, 0, 0}, .radius = 1e-3, .density = 1000});
    s.add({.position = {2e-3 * (1 - 1e-6), 0, 0}, .radius = 1e-3, .density = 1000, .velocity = {-1e-3, 0, 0}});
    s.run(3);
    return s;
  };
  auto asked = make(), alone = make();
  std::string message;
  try {
    asked.distribute_liquid(1.1e-15);
  } catch (const input_error& e) {
    message = e.what();
  }
  CHECK(message.find("the slope of the capillary force") != std::string::npos);
  const ledger& book = asked.bridges().book();
  CHECK((book.introduced() == 0 && book.total() == 0 && asked.bridges().count() == 0));
  asked.run(50);
  alone.run(50);
  for (const std::int64_t id : {0, 1}) CHECK(position(asked, id) == position(alone, id));
  asked.distribute_liquid(1e-11);
  CHECK(book.total() == 1e-11);
}

TEST_CASE("a film put on a grain makes a bridge at its next contact, listed anew before it or not") {
  for (const double gap : {0.01 * radius, 0.1 * radius}) {
    auto s = two_far_grains(gap, 0.02, protocol::grain_films{}, 1.0);
    s.exchange("spray", [](auto& door) {
      door.for_each_grain([&](std::size_t grain) {
        if (door.id(grain) == 1) door.wet_grain(grain, 1e-12);
      });
    });
    CHECK(s.bridges().count() == 0);
    std::size_t most = 0;
    for (int k = 0; k < 150; ++k) {
      s.run(20);
      most = std::max(most, s.bridges().count());
    }
    CHECK(most == 1);
    CHECK(s.bridges().book().total() == within(1e-14, 1e-12));
    CHECK(s.bridges().book().outside("spray") == -1e-12);
    CHECK(s.bridges().book().introduced() == 0);
  }
}

TEST_CASE("a film put on a grain joins its bridge at once under the protocol of the neighbours") {
  auto s = two_far_grains(1e-6, 0, protocol::neighbours{}, 1.0);
  s.distribute_liquid(1e-12);
  s.exchange("spray", [](auto& door) { door.wet_grain(0, 2e-13); });
  CHECK(s.bridges().book().bonds()[0] == within(1e-14, 1.2e-12));
  s.run(1);
  CHECK(s.bridges().breaks_above(0) == within(1e-12, std::cbrt(1.2e-12)));
}

TEST_CASE("more than there is cannot be taken by hand, and nothing is taken then") {
  auto s = two_far_grains(1e-6, 0, protocol::neighbours{}, 1.0);
  s.distribute_liquid(1e-12);
  const double all = s.bridges().book().bonds()[0];
  const auto take = [&](double first, double then) {
    s.exchange("pump", [&](auto& door) {
      door.drain_bridge(0, first);
      door.drain_bridge(0, then);
    });
  };
  CHECK_THROWS_AS(take(6e-13, 6e-13), input_error);
  CHECK_THROWS_AS(take(6e-13, -1e-13), input_error);
  CHECK_THROWS_AS(take(6e-13, std::nan("")), input_error);
  CHECK((s.bridges().book().bonds()[0] == all && s.bridges().book().outside("pump") == 0));
  CHECK_THROWS_AS(s.exchange("pump", [](auto& door) { door.dry_grain(1, 1e-30); }), input_error);
  CHECK_THROWS_AS(s.exchange("pump", [](auto& door) { door.wet_grain(2, 1e-15); }), input_error);  // there are two
  CHECK_THROWS_AS(s.exchange(source::evaporation{-1, 0}), input_error);
  CHECK_THROWS_AS(s.exchange(source::evaporation{1, 0, 0}), input_error);
  CHECK((s.bridges().book().bonds()[0] == all && s.bridges().book().outside("vapour") == 0));
  take(0.5 * all, all - 0.5 * all);
  CHECK((s.bridges().count() == 0 && s.bridges().book().outside("pump") == all));
  CHECK(s.bridges().attraction(0, block(1e-6))[0] == 0);
}

namespace {
/// A heap of wet grains on a floor.
template <class Integration>
auto heap() {
  pendular::system s{
      material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}},
      liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}}, floor_plane(),
      Integration{2e-6, {1.5, 0, -9.81}}, run_options{.force = true}};
  for (const grain& g : loose_lattice(3, 3, 3, radius, 0.1, 1.2e-3, 0.1)) s.add(g);
  s.add({.position = {0.03, 0, radius}, .radius = radius, .density = 2600});  // 27 and 28, far away
  s.add({.position = {0.03 + 2 * radius, 0, radius}, .radius = radius, .density = 2600});
  s.run(2000);
  s.distribute_liquid(2e-12 * 27);
  return s;
}

template <class S>
void expect_same(const S& a, const S& b, std::int64_t ids) {
  for (std::int64_t id = 0; id < ids; ++id) {
    const grain x = a.particles()[a.particles().row_of(id)], y = b.particles()[b.particles().row_of(id)];
    REQUIRE((x.position == y.position && x.velocity == y.velocity && x.angular_velocity == y.angular_velocity));
  }
}
}  // namespace

TEST_CASE("bridges that have just formed or broken are no concern of a grain that is added far away") {
  const auto swarm = [] {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}},
                       liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}},
                       floor_plane(), half_step_velocity_verlet{5e-6, {0, 0, -9.81}}, run_options{.force = true}};
    for (const grain& g : loose_lattice(4, 4, 4, radius, 0.05, 1.15e-3, 0.4)) s.add(g);
    s.distribute_liquid(2e-12 * 64);
    return s;
  };
  auto alone = swarm(), disturbed = swarm();
  std::int64_t events = 0;
  int added = 0;
  for (int step = 0; step < 1500; ++step) {
    alone.run(1);
    disturbed.run(1);
    const std::int64_t now = disturbed.events().ruptures + disturbed.events().formations;
    if (now != events) disturbed.add({.position = {0.05, 0.002 * ++added, radius}, .radius = radius, .density = 2600});
    events = now;
  }
  CHECK(added > 50);
  expect_same(alone, disturbed, 64);
}

TEST_CASE("a contact that has just closed dry stays dry under a film put on it, in an old list as in a new one") {
  for (const bool listed_anew : {false, true}) {
    auto s = two_far_grains(1e-6, 0.02, protocol::grain_films{}, 1.0);
    while (gap_of(s, 0, 1) >= 0) s.run(1);
    if (listed_anew) s.canonicalise();
    s.exchange("spray", [](auto& door) { door.wet_grain(0, 1e-12); });
    CHECK(s.bridges().count() == 0);
    s.run(5);
    CHECK((gap_of(s, 0, 1) < 0 && s.bridges().count() == 0));
  }
}

TEST_CASE("a wall's bridge that is drained by hand pulls at once as one that never had more") {
  const auto drop = [](double volume) {
    pendular::system s{material{normal::linear{1e3}},
                       liquid{fluid::water(), capillary::bagheri{}, rupture::willett{}, protocol::grain_films{}},
                       boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{},
                                                      boundary::wettable{}}},
                       velocity_verlet{1e-7}, run_options{.force = true}};
    s.add({.position = {0, 0, 1.01 * radius}, .radius = radius, .density = 2600});
    s.add({.position = {0.01, 0, 1.01 * radius}, .radius = radius, .density = 2600});
    s.distribute_liquid(2 * volume);
    return s;
  };
  const auto pull = [](const auto& s, std::int64_t id) {
    double force = 0;
    s.for_each_wall([&](const auto&, const auto& contacts) {
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (contacts.row(k) == s.particles().row_of(id)) force = contacts.force(k).z;
      }
    });
    return force;
  };
  auto s = drop(1e-12);
  const double before = pull(s, 1);
  s.exchange("pump", [](auto& door) {
    door.for_each_bridge([&](std::size_t pair) {
      if (door.is_at_wall(pair) && door.ids(pair).first == 0) door.drain_bridge(pair, 0.5e-12);
    });
  });
  CHECK(pull(s, 0) == within(1e-9, pull(drop(0.5e-12), 0)));
  CHECK(std::abs(pull(s, 0)) < 0.99 * std::abs(before));
  CHECK(pull(s, 1) == before);  // the other grain does not notice
  CHECK(velocity(s, 1) == vector{0, 0, 0});
  s.remove(std::vector<std::int64_t>{0});
  CHECK((s.bridges().count() == 1 && pull(s, 1) == before));
  CHECK(s.bridges().book().outside("taken out") == within(1e-9, 0.5e-12));
}

TEST_CASE("a held grain's other contacts are no concern of the friction that counts contacts") {
  const auto slide = [](int others) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}, friction::viscous_coulomb{1, 0.4}},
                       boundary::walls{}, velocity_verlet{1e-6, {0, 0, -9.81}}, run_options{.force = true}};
    s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
    s.add({.position = {0, 0, 1.9999 * radius}, .radius = radius, .density = 2600, .velocity = {0.01, 0, 0}});
    for (int k = 0; k < others; ++k) {
      const double x = k == 0 ? 1 : -1;
      s.add({.position = {1.9 * radius * x, 0, -0.6 * radius}, .radius = radius, .density = 2600});
    }
    for (int k = 0; k < others; ++k) s.drive(2 + k);
    s.drive(0);
    s.run(500);
    return s;
  };
  const auto alone = slide(0), among = slide(2);
  CHECK(among.particles().get<column::contacts>()[among.particles().row_of(1)] == 1);
  expect_same(alone, among, 2);
}

TEST_CASE("a turning drum resumes with the same bits, its work included") {
  const auto drum = [] {
    return pendular::system{
        material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}},
        boundary::walls{boundary::wall{boundary::cylinder{{0, 0, 0}, {0, 1, 0}, 3e-3},
                                       boundary::turning{{0, 0, 0}, {0, 1, 0}, -20}},
                        boundary::wall{boundary::plane{{0, 0, -2.8e-3}, {0, 0.6, 0.8}},
                                       boundary::turning{{0, 0, 0}, {0, 1, 0}, 0.5, 3e-3}}},
        velocity_verlet{2e-6, {0, 0, -9.81}}, run_options{.force = true}};
  };
  auto first = drum();
  for (int k = 0; k < 6; ++k) first.add({.position = {1e-3 * (k - 2.5), 0, 0}, .radius = 0.48e-3, .density = 2600});
  first.run(8000);
  first.canonicalise();
  const auto file = std::filesystem::temp_directory_path() / ("pendular_drum_" + std::to_string(std::rand()));
  {
    io::checkpoint_writer out(file);
    io::save(out, first);
    out.commit();
  }
  auto second = drum();
  CHECK(io::load(io::checkpoint_reader(file), second).empty());  // where walls stand and what they feel is no parameter
  std::filesystem::remove(file);
  first.run(3000);
  second.run(3000);
  expect_same(first, second, 6);
  CHECK(observe::energies_of(first).walls != 0);
  CHECK(observe::energies_of(first).walls == observe::energies_of(second).walls);
  CHECK(boundary::get<0>(first.walls()).drive.torque == boundary::get<0>(second.walls()).drive.torque);
  CHECK(boundary::get<1>(first.walls()).shape.normal == boundary::get<1>(second.walls()).shape.normal);
}

TEST_CASE("walls that move or turn do no work while their scene stands") {
  using boundary::plane;
  using boundary::wall;
  pendular::system s{material{normal::linear{1e3}, friction::coulomb_spring{800, 0.4}},
                     boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::constant_velocity{{0, 0, 0.01}}},
                                     wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::turning{{0, 0, 0}, {0, 0, 1}, 5}}},
                     velocity_verlet{1e-6, {0, 0, -9.81}}, run_options{.force = true}};
  s.add({.position = {3e-3, 0, 0.999 * radius}, .radius = radius, .density = 2600});
  s.run(20);
  const double pushed = boundary::get<0>(s.walls()).work, turned = boundary::get<1>(s.walls()).work;
  REQUIRE((pushed > 0 && turned > 0));
  s.add({.position = {0.05, 0, 2 * radius}, .radius = radius, .density = 2600});
  s.start();
  CHECK((boundary::get<0>(s.walls()).work == pushed && boundary::get<1>(s.walls()).work == turned));
}

TEST_CASE("grains are taken out with their liquid, and nobody else notices") {
  auto all = heap<velocity_verlet>(), fewer = heap<velocity_verlet>();
  all.run(1000);
  fewer.run(1000);
  REQUIRE(observe::coordination_of(fewer).bridges > 1);
  fewer.remove(std::vector<std::int64_t>{28});
  all.run(1000);
  fewer.run(1000);
  expect_same(all, fewer, 27);
  CHECK(fewer.particles().size() == 28);
  const ledger& book = fewer.bridges().book();
  CHECK(book.outside("taken out") > 0);
  CHECK(book.total() + book.outside("taken out") == within(1e-12, book.introduced()));
  fewer.remove(std::vector<std::int64_t>{0, 13, 5});
  fewer.run(1000);
  CHECK(book.total() + book.outside("taken out") == within(1e-12, book.introduced()));
  fewer.add({.position = {0.05, 0, radius}, .radius = radius, .density = 2600});
  CHECK(fewer.particles()[fewer.particles().row_of(29)].position.x == 0.05);  // ids are not given twice
  fewer.run(10);
}

TEST_CASE("a grain that is not there, twice out, and the last one are refused, and nothing has changed") {
  auto s = heap<velocity_verlet>(), alone = heap<velocity_verlet>();
  CHECK_THROWS_AS(s.remove({3, 99}), input_error);
  CHECK_THROWS_AS(s.remove({-1}), input_error);
  CHECK_THROWS_AS(s.drive(99), input_error);
  CHECK_THROWS_AS(s.release(3), input_error);
  CHECK_THROWS_AS(s.drive(3, {std::nan(""), 0, 0}), input_error);
  s.drive(28);
  CHECK_THROWS_AS(s.drive(28, {1, 0, 0}), input_error);
  s.release(28);
  CHECK_THROWS_AS(s.run(-1), input_error);
  s.run(100);
  alone.run(100);
  expect_same(s, alone, 27);  // all that do not touch 28, which was stopped
  pendular::system one{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6}};
  one.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  CHECK_THROWS_AS(one.remove(std::vector<std::int64_t>{0}), input_error);
  CHECK(one.particles().size() == 1);
}

TEST_CASE("a grain is taken out by its id, also before the grains have their places in the list") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-7}};
  for (int k = 0; k < 9; ++k) s.add({.position = {0.01 * (8 - k), 0, 0}, .radius = radius, .density = 2600});
  s.remove(std::vector<std::int64_t>{0, 1});
  CHECK((s.particles().size() == 7 && !s.particles().has_id(0) && !s.particles().has_id(1)));
}

TEST_CASE("a held grain stays, a driven one moves as it is told, and what they take is in the books") {
  const auto check = [](const auto& integrator) {
    const double speed = 0.05, k = 1e3, m = sphere_mass(radius, 2600);
    pendular::system s{material{normal::linear{k}, damping::viscous{0.3}, energy_book{}}, boundary::walls{},
                       integrator};
    s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
    s.add({.position = {2.001 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {-speed, 0, 0}});
    s.add({.position = {0, 0.01, 0}, .radius = radius, .density = 2600});
    s.drive(0);
    s.drive(2, {0, 0.3, 0});
    s.start();
    const auto from = observe::energies_of(s);
    const double dt = integrator.time_step;
    const auto steps = static_cast<std::int64_t>(4e-4 / dt);
    s.run(steps);
    CHECK((position(s, 0) == vector{0, 0, 0} && velocity(s, 0) == vector{0, 0, 0}));
    CHECK(position(s, 2).y == within(1e-12, 0.01 + 0.3 * dt * static_cast<double>(steps)));
    // Against a grain that cannot give way the reduced mass is that of the other: ln e = -pi a / sqrt(1 - a^2).
    CHECK(velocity(s, 1).x == within(1e-2, speed * std::exp(-pi * 0.3 / std::sqrt(1 - 0.09))));
    const auto to = observe::energies_of(s);
    CHECK(to.balance() == near(1e-3 * 0.5 * m * speed * speed, from.balance()));
  };
  check(velocity_verlet{1e-7});
  check(half_step_velocity_verlet{1e-7});
}

TEST_CASE("pushing a grain with another that is driven takes the work that it gains") {
  pendular::system s{material{normal::linear{1e3}, energy_book{}}, boundary::walls{}, velocity_verlet{1e-7}};
  s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  s.add({.position = {2.001 * radius, 0, 0}, .radius = radius, .density = 2600});
  s.drive(0, {0.1, 0, 0});
  s.run(4000);
  const double m = sphere_mass(radius, 2600);
  CHECK(velocity(s, 1).x == within(1e-3, 0.2));  // elastic, from a body that does not give way
  CHECK(s.driven().work() == within(1e-3, 0.5 * m * 0.04));
  s.release(0);
  s.run(10);
  CHECK(velocity(s, 0).x == 0.1);
}

TEST_CASE("a driven grain has its velocities at once, and what weight and friction take from it is in the books") {
  pendular::system s{
      material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}},
      liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}}, floor_plane(),
      velocity_verlet{2e-6, {0, 0, -9.81}}, run_options{.force = true}};
  const double overlap = 1e-3 * radius, spin = 20, speed = 0.1;
  s.add({.position = {0, 0, 5e-3}, .radius = radius, .density = 2600});
  s.add({.position = {0.03, 0, radius - overlap}, .radius = radius, .density = 2600});
  s.drive(0, {0, 0, speed});
  s.drive(1, {0, 0, 0}, {0, spin, 0});
  CHECK(velocity(s, 0) == vector{0, 0, speed});
  CHECK(s.particles()[row_of(s, 1)].angular_velocity == vector{0, spin, 0});
  s.run(2000);
  const double time = s.time(), lifted = sphere_mass(radius, 2600) * 9.81 * speed * time;
  const double dragged = 0.4 * 1e3 * overlap * (radius - overlap) * spin * time;
  REQUIRE((lifted > 0.2 * dragged && dragged > 0.2 * lifted));
  CHECK(s.driven().work() == within(0.01, lifted + dragged));  // less while the friction spring is laid down
}

TEST_CASE("a grain that is released again is in its contacts as one that was never held") {
  const auto hit = [](bool held) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}, energy_book{}}, boundary::walls{},
                       velocity_verlet{1e-7}};
    s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
    s.add({.position = {2.001 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {-0.05, 0, 0}});
    if (held) s.drive(0);
    s.run(10);
    if (held) s.release(0);
    s.run(4000);
    return s;
  };
  expect_same(hit(false), hit(true), 2);
}

TEST_CASE("a run with grains taken out and driven resumes with the same bits") {
  auto first = heap<half_step_velocity_verlet>();
  first.drive(4);
  first.drive(28, {0.02, 0, 0});
  first.run(300);
  first.remove(std::vector<std::int64_t>{11, 2});
  first.run(300);
  first.canonicalise();
  const auto file = std::filesystem::temp_directory_path() / "pendular_standing.state";
  {
    io::checkpoint_writer out(file);
    io::save(out, first);
    out.commit();
  }
  pendular::system second{first.contact_material(), first.bridges().policies(), first.walls(), first.integrator(),
                          run_options{.force = true}};
  io::load(io::checkpoint_reader(file), second);
  std::filesystem::remove(file);
  CHECK(observe::coordination_of(second).contacts == observe::coordination_of(first).contacts);
  CHECK(observe::energies_of(second).balance() == observe::energies_of(first).balance());
  CHECK(observe::love_weber_stress(second, 1) == observe::love_weber_stress(first, 1));
  second.add({.position = {0.06, 0, radius}, .radius = radius, .density = 2600});  // concerns nobody
  first.run(500);
  second.run(500);
  for (const std::int64_t id : {0, 1, 3, 4, 5, 10, 12, 26, 27, 28}) {
    const grain x = first.particles()[first.particles().row_of(id)],
                y = second.particles()[second.particles().row_of(id)];
    REQUIRE((x.position == y.position && x.velocity == y.velocity && x.angular_velocity == y.angular_velocity));
  }
  CHECK(first.driven().work() == second.driven().work());
}

TEST_CASE("a grain that is driven and taken out is driven no more") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-7}};
  for (int k = 0; k < 3; ++k) s.add({.position = {0.01 * k, 0, 0}, .radius = radius, .density = 2600});
  s.drive(1, {0.1, 0, 0});
  s.drive(2, {0, 0.1, 0});
  s.remove({1});
  CHECK((!s.driven().is_driven(1) && s.driven().is_driven(2)));
  CHECK_THROWS_AS(s.release(1), input_error);
}

TEST_CASE("a grain may be put in far beyond all others of a scene that has run") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6}};
  s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  s.run(10);
  s.add({.position = {5, 0, 0}, .radius = radius, .density = 2600});
  s.run(10);
  s.canonicalise();
  CHECK(position(s, 1) == vector{5, 0, 0});
}

TEST_CASE("a fast wall makes the skin wide, and a list lasts until the wall has come half of it nearer") {
  pendular::system s{material{normal::linear{1e3}},
                     boundary::walls{boundary::wall{boundary::plane{{0, 0, -0.01}, {0, 0, 1}},
                                                    boundary::constant_velocity{{0, 0, 1}}}},
                     velocity_verlet{1e-6}};
  s.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  s.run(1000);  // 1e-6 m in each: a skin of sqrt(57 2e-3) = 0.34 radii, and 85 steps for half of it
  CHECK((s.rebuild_count() > 8 && s.rebuild_count() < 20));
}

TEST_CASE("friction that counts contacts knows them before the first step") {
  pendular::system s{material{normal::linear{1e3}, friction::viscous_coulomb{1, 0.4}}, floor_plane(),
                     velocity_verlet{1e-6}};
  for (int k = 0; k < 3; ++k) {
    s.add({.position = {1.999 * radius * k, 0, 0.999 * radius}, .radius = radius, .density = 2600});
  }
  s.start();
  const auto contacts = s.particles().get<column::contacts>();
  CHECK((contacts[row_of(s, 0)] == 2 && contacts[row_of(s, 1)] == 3 && contacts[row_of(s, 2)] == 2));
}

TEST_CASE("another time step keeps the time, and an unstable one is refused") {
  auto s = two_far_grains(0.1 * radius, 0.01, protocol::none{}, 1.0);
  s.change_integrator({5e-7});
  CHECK(s.time() == within(1e-15, 1e-5));
  s.run(10);
  CHECK(s.time() == within(1e-14, 1.5e-5));
  CHECK(position(s, 1).z == within(1e-12, 2.1 * radius - 0.01 * 1.5e-5));
  CHECK_THROWS_AS(s.change_integrator({1e-2}), input_error);
  CHECK_THROWS_AS(s.change_integrator({-1e-7}), input_error);
  CHECK(s.integrator().time_step == 5e-7);
}

TEST_CASE("observers ask for forces in a sentence where they are not known, and see those of a resumed run") {
  pendular::system s{material{normal::linear{1e3}, energy_book{}}, boundary::walls{}, velocity_verlet{1e-6}};
  s.add({.position = {0, 0, 0}, .radius = 1e-3, .density = 2600});
  s.add({.position = {1.9999e-3, 0, 0}, .radius = 1e-3, .density = 2600});
  const auto refused = [](const auto& ask) {
    try {
      ask();
    } catch (const input_error& e) {
      return std::string(e.what()).find("call start() or run() first") != std::string::npos;
    }
    return false;
  };
  const auto all_refuse = [&] {
    CHECK(refused([&] { observe::energies_of(s); }));
    CHECK(refused([&] { observe::pairs(s); }));
    CHECK(refused([&] { observe::coordination_of(s); }));
    CHECK(refused([&] { observe::love_weber_stress(s, 1); }));
    CHECK(refused([&] { observe::unbalanced_force_ratio(s); }));
    CHECK(refused([&] { observe::grain_pressures(s); }));
    CHECK(refused([&] { observe::fabric_tensor(s); }));
  };
  all_refuse();
  s.start();
  CHECK(observe::energies_of(s).elastic == within(1e-6, 0.5 * 1e3 * 1e-14));
  s.add({.position = {0, 1, 0}, .radius = 1e-3, .density = 2600});
  all_refuse();
}

TEST_CASE("observers see contacts as they were when a grain is added far away") {
  pendular::system s{material{normal::linear{1e3}, energy_book{}}, boundary::walls{}, velocity_verlet{1e-6}};
  s.add({.position = {0, 0, 0}, .radius = 1e-3, .density = 2600});
  s.add({.position = {1.9999e-3, 0, 0}, .radius = 1e-3, .density = 2600});
  s.run(3);
  const double elastic = observe::energies_of(s).elastic;
  REQUIRE(elastic > 0);
  s.add({.position = {0, 1, 0}, .radius = 1e-3, .density = 2600});
  s.start();
  CHECK(observe::energies_of(s).elastic == elastic);
  CHECK(observe::coordination_of(s).contacts == within(1e-14, 2.0 / 3));
}

TEST_CASE("the range of pairs has the real pairs, in the order of ids, and composes with views") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6}};
  s.add({.position = {1.99e-3, 0, 0}, .radius = 1e-3, .density = 2600});
  s.add({.position = {0, 0, 0}, .radius = 1e-3, .density = 2600});
  s.add({.position = {0, 2.01e-3, 0}, .radius = 1e-3, .density = 2600});
  s.start();
  CHECK(s.contacts().gap().size() == 2);
  std::vector<std::pair<std::int64_t, std::int64_t>> ids;
  for (const observe::pair& p : observe::pairs(s)) ids.push_back(p.ids);
  CHECK(ids == std::vector<std::pair<std::int64_t, std::int64_t>>{{0, 1}, {1, 2}});
  double push = 0;
  int count = 0;
  for (const double f :
       observe::pairs(s) | ::ranges::views::filter(observe::touching) | ::ranges::views::transform(observe::push_of)) {
    push += f;
    ++count;
  }
  CHECK(count == 1);
  CHECK(push == within(1e-9, 1e3 * 1e-5));
  const observe::pair first = *observe::pairs(s).begin();
  CHECK((first.normal() == vector{-1, 0, 0} && first.gap == within(1e-9, -1e-5) && first.bridge_volume == 0));
  CHECK(first.force.x == within(1e-9, 1e-2));
}

TEST_CASE("an empty scene is refused in a sentence wherever it is asked") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6}};
  CHECK_THROWS_AS(s.start(), input_error);
  CHECK_THROWS_AS(s.run(1), input_error);
  CHECK_THROWS_AS(s.limits(), input_error);
  CHECK_THROWS_AS(s.canonicalise(), input_error);
  CHECK_THROWS_AS(s.expect_limits(), input_error);
}
