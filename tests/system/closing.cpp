// SPDX-License-Identifier: BSD-3-Clause
// Which contacts count as new when a film arrives, in a running scene: through new neighbour lists and a checkpoint.
#include "../catch.hpp"

#include <pendular/io/system_state.hpp>
#include <pendular/pendular.hpp>

#include <filesystem>

using namespace pendular;

namespace {
constexpr double heavy = 2.6e9, radius = 0.5e-3, volume = 0.01 * radius * radius * radius;

/// Grains 0 - 1 - 2 in a row, 1 and 2 pressed a little; the seed leaves their contact dry. 0 flies away.
template <class Formation>
auto row_of_three(const Formation& formation, double skin) {
  // So soft and heavy that nothing pushes or pulls 1 and 2 apart meanwhile.
  pendular::system s{material{normal::linear{1e-3}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}, formation},
                     boundary::walls{}, velocity_verlet{1e-6}, run_options{.skin = skin, .force = true}};
  const double touch = 2 * radius - 1e-9;
  s.add({.position = {0, 0, 0}, .radius = radius, .density = heavy, .velocity = {-0.5, 0, 0}});
  s.add({.position = {touch, 0, 0}, .radius = radius, .density = heavy});
  s.add({.position = {touch + 2 * radius - 1e-8, 0, 0}, .radius = radius, .density = heavy});
  bond_selection selection{2, 0};
  while (!selection.keeps(0, 1) || selection.keeps(1, 2)) ++selection.seed;
  s.distribute_liquid(volume, selection);
  REQUIRE(s.bridges().count() == 1);
  return s;
}

template <class System>
double gap_of_1_and_2(const System& s) {
  const auto rows = s.particles().rows_by_id();
  const auto position = s.particles().template get<column::position>();
  return norm(position[rows[2]] - position[rows[1]]) - 2 * radius;
}

constexpr std::int64_t after_rupture = 400;
}  // namespace

TEST_CASE("a film that reaches a grain makes no bridge at a contact that has long been closed") {
  for (const double skin : {0.2, 1e-5}) {  // with one list for all, and with a new list in nearly every step
    auto s = row_of_three(formation::at_contact{}, skin);
    s.run(after_rupture);
    CHECK(s.events().ruptures == 1);
    CHECK(s.events().formations == 0);
    CHECK(s.bridges().count() == 0);
    CHECK((s.rebuild_count() > 100) == (skin < 1e-4));
    REQUIRE(gap_of_1_and_2(s) < 0);
  }
}

TEST_CASE("it does under a rule that looks at the gap alone") {
  auto s = row_of_three(formation::within_rupture_distance{}, 0.2);
  s.run(after_rupture);
  CHECK(s.events().formations > 0);
}

TEST_CASE("a resumed run still knows which contacts are closed") {
  const auto file = std::filesystem::temp_directory_path() / ("pendular_closing_" + std::to_string(std::rand()));
  auto s = row_of_three(formation::at_contact{}, 0.2);
  s.run(after_rupture);
  s.canonicalise();
  io::checkpoint_writer out(file);
  io::save(out, s);
  out.commit();
  pendular::system fresh{s.contact_material(), s.bridges().policies(), boundary::walls{}, s.integrator(),
                         run_options{.force = true}};
  io::load(io::checkpoint_reader(file), fresh);
  fresh.run(100);
  CHECK(fresh.events().ruptures == 1);
  CHECK(fresh.events().formations == 0);
  REQUIRE(gap_of_1_and_2(fresh) < 0);
  std::filesystem::remove(file);
}
