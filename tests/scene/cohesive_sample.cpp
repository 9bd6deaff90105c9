// SPDX-License-Identifier: BSD-3-Clause
// A box of 150 grains, in short durations: compaction, walls that let go, liquid, the promise of the checkpoints.
#include "../catch.hpp"
#include "../io/scratch.hpp"
#include "checkpoints.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/scene/cohesive_sample.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace pendular;

namespace {
const material smooth{normal::linear{1e3}, damping::viscous{0.8}};
const material rough{normal::linear{1e3}, damping::viscous{0.8}, friction::coulomb_spring{800, 0.4}};
const material walls{normal::linear{1e3}, damping::viscous{0.8}, energy_book{}};
const material wet_contact{normal::linear{1e3}, damping::viscous{0.8}, friction::viscous_coulomb{1, 0.4},
                           energy_book{}};
const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::neighbours{}};

scene::box_packing_parameters small_box() {
  scene::box_packing_parameters p;
  p.grains = 150;
  p.compaction = 0.2;
  p.unbalanced_force = 1e-2;
  return p;
}

template <class Material>
scene::boxed_packing compacted(const Material& m) {
  return scene::box_packing(small_box(), m, walls).run({});
}
const scene::boxed_packing& dense() {
  static const scene::boxed_packing done = compacted(smooth);
  return done;
}

scene::cohesive_parameters small_test() {
  scene::cohesive_parameters p;
  p.relaxation = 0.2;
  p.unbalanced_force = 2e-2;
  return p;
}

auto relaxed(const scene::cohesive_parameters& p) {
  scene::cohesive_sample test(p, wet_contact, walls, water);
  test.start(dense());
  test.run({});
  return test;
}

std::vector<double> numbers_of(const scene::boxed_packing& p) {
  std::vector<double> all{p.stress, p.unbalanced_force};
  for (const vector& v : {p.room.lower, p.room.upper}) all.insert(all.end(), {v.x, v.y, v.z});
  for (const grain& g : p.grains) all.insert(all.end(), {g.position.x, g.position.y, g.position.z, g.radius});
  return all;
}

template <class Test>
std::vector<double> numbers_of(const Test& test) {
  std::vector<double> all;
  for_each_number(test.result(), [&](const double& v) { all.push_back(v); });
  const auto& g = test.sample().particles();
  for (const std::size_t row : g.rows_by_id()) {
    for (const vector& v : {g.template get<column::position>()[row], g.template get<column::angular_velocity>()[row],
                            g.template get<column::force>()[row]}) {
      all.insert(all.end(), {v.x, v.y, v.z});
    }
  }
  return all;
}

bool is_inside(const scene::boxed_packing& p) {
  return std::all_of(p.grains.begin(), p.grains.end(), [&](const grain& g) {
    const vector low = g.position - p.room.lower, high = p.room.upper - g.position;
    return std::min({low.x, low.y, low.z, high.x, high.y, high.z}) > 0.99 * g.radius;
  });
}
}  // namespace

TEST_CASE("a loose lattice has all grains apart in a cubic box, in an order of its seed") {
  const auto sizes = scene::diameters(scene::cohesive_grading(), 200, 3);
  const auto loose = scene::loose_lattice(sizes, 2700, 0.1, 3);
  REQUIRE(loose.grains.size() == 200);
  CHECK(loose.room.upper == -loose.room.lower);
  CHECK(is_inside({loose.grains, loose.room}));
  double nearest = 1, fastest = 0;
  for (std::size_t a = 0; a < 200; ++a) {
    CHECK(2 * loose.grains[a].radius == sizes[a]);
    fastest = std::max(fastest, std::abs(loose.grains[a].velocity.y));
    for (std::size_t b = 0; b < a; ++b) {
      const grain &g = loose.grains[a], &h = loose.grains[b];
      nearest = std::min(nearest, norm(g.position - h.position) - g.radius - h.radius);
    }
  }
  CHECK(nearest > 0);
  CHECK((fastest > 0.05 && fastest <= 0.1));
  const auto again = scene::loose_lattice(sizes, 2700, 0.1, 3), other = scene::loose_lattice(sizes, 2700, 0.1, 4);
  CHECK(loose.grains[7].position == again.grains[7].position);
  CHECK_FALSE(loose.grains[7].position == other.grains[7].position);
  CHECK_THROWS_AS(scene::loose_lattice({}, 2700, 0.1, 1), input_error);
}

TEST_CASE("grains of all sizes are everywhere in a loose lattice") {
  for (const std::int64_t count : {8000, 1000, 700}) {  // two full cubes, one with holes
    const auto loose = scene::loose_lattice(scene::diameters(scene::cohesive_grading(), count, 1), 2700, 0.1, 1);
    vector small{0, 0, 0}, large{0, 0, 0};
    double smalls = 0, larges = 0;
    for (const grain& g : loose.grains) {
      if (g.radius < 0.6e-3) small += g.position, ++smalls;
      if (g.radius > 0.9e-3) large += g.position, ++larges;
    }
    const vector apart = (1 / smalls) * small - (1 / larges) * large;
    const double scatter = loose.room.upper.x / std::sqrt(3) * std::sqrt(1 / smalls + 1 / larges);
    for (const double x : {apart.x, apart.y, apart.z}) CHECK(std::abs(x) < 4 * scatter);
  }
}

TEST_CASE("compacted grains press on all six walls with the pressure, and friction keeps them looser") {
  scene::box_packing packing(small_box(), smooth, walls);
  const scene::boxed_packing p = packing.run({});
  CHECK(p.grains.size() == 150);
  CHECK(is_inside(p));
  CHECK(p.unbalanced_force <= 1e-2);
  CHECK(p.stress == near(3, 300));
  scene::detail::for_each_face(packing.sample().walls(), [&](const scene::box_wall& wall, double area) {
    CHECK(-dot(wall.force, wall.shape.normal) / area == within(0.1, 300));
    CHECK(wall.drive.area == within(1e-2, area));
  });
  CHECK(compacted(rough).solid_fraction() < p.solid_fraction());
}

TEST_CASE("without confining pressure the walls neither press nor pull, and stay near the sample") {
  const auto test = relaxed(small_test());
  CHECK(test.at_rest());
  scene::detail::for_each_face(test.sample().walls(), [&](const scene::box_wall& wall, double area) {
    CHECK(std::abs(dot(wall.force, wall.shape.normal)) / area < 3);
    CHECK(norm(wall.drive.velocity) < 2e-3);
  });
  CHECK(std::abs(test.result().records.back().wall_stress) < 1);
  const vector before = scene::size_of(dense().room), after = scene::size_of(test.result().end.room);
  for (const double ratio : {after.x / before.x, after.y / before.y, after.z / before.z}) {
    CHECK((ratio > 0.97 && ratio < 1.03));
  }
}

TEST_CASE("a confining pressure stays on the walls") {
  auto p = small_test();
  p.confining_pressure = 100;
  CHECK(relaxed(p).result().records.back().wall_stress == near(1, 100));
}

TEST_CASE("liquid is kept to round-off and the energy book closes") {
  const auto test = relaxed(small_test());
  const auto& r = test.result();
  CHECK(r.start.bridges > r.start.contacts);
  CHECK(r.packing_unbalanced_force == dense().unbalanced_force);
  CHECK(test.sample().bridges().book().introduced() ==
        within(1e-12, 0.007 * dense().solid_mass() / fluid::water().density));
  for (const auto& line : r.records) {
    CHECK(line.liquid == near(1e-12, 1.0));
    CHECK(std::abs(line.energy.imbalance) < 0.05 * line.energy.turnover);
  }
}

TEST_CASE("with inertia times four and twice the time step as much liquid comes and rest is found too") {
  auto p = small_test();
  p.mass_scaling = 4;
  p.time_step *= 2;
  const auto test = relaxed(p);
  CHECK(test.at_rest());
  CHECK(test.sample().bridges().book().introduced() ==
        within(1e-12, 0.007 * dense().solid_mass() / fluid::water().density));
}

TEST_CASE("a compaction that is resumed from any checkpoint ends with the same bits") {
  const scratch::folder folder;
  std::vector<std::filesystem::path> kept;
  scene::box_packing packing(small_box(), rough, walls);
  const auto whole = numbers_of(packing.run(checkpoints::watching(folder, 4000, kept)));
  REQUIRE(kept.size() > 2);
  for (const auto& from : kept) {
    scene::box_packing again(small_box(), rough, walls);
    again.resume(io::checkpoint_reader(from));
    CAPTURE(from.filename().string());
    CHECK((numbers_of(again.run(checkpoints::written_to(folder / "again", 4000))) == whole));
  }
}

TEST_CASE("a relaxation that is resumed from any checkpoint ends with the same bits") {
  const scratch::folder folder;
  std::vector<std::filesystem::path> kept;
  scene::cohesive_sample test(small_test(), wet_contact, walls, water);
  test.start(dense());
  test.run(checkpoints::watching(folder, 500, kept));
  REQUIRE(kept.size() > 2);
  for (const auto& from : kept) {
    scene::cohesive_sample again(small_test(), wet_contact, walls, water);
    again.resume(io::checkpoint_reader(from));
    again.run(checkpoints::written_to(folder / "again", 500));
    CAPTURE(from.filename().string());
    CHECK((numbers_of(again) == numbers_of(test)));
  }
}

TEST_CASE("a sample at rest where a checkpoint is due has its forces all the same") {
  auto p = small_test();
  p.unbalanced_force = 1e9;
  p.stress_tolerance = 1e9;  // at rest after the first record
  const scratch::folder folder;
  scene::cohesive_sample test(p, wet_contact, walls, water);
  test.start(dense());
  test.run(checkpoints::written_to(folder / "checkpoint", 250));
  REQUIRE(test.result().records.size() == 1);
  CHECK(observe::tensile_coordination(test.sample()) > 0);
}

TEST_CASE("a packing in a box is written and read back, and refused by a job of another sample") {
  const scratch::folder folder;
  scene::write(dense(), folder / "packing");
  const io::checkpoint_reader in(folder / "packing");
  CHECK((numbers_of(scene::load_boxed_packing(in, small_box())) == numbers_of(dense())));
  auto other = small_box();
  other.grains = 151;
  CHECK_THROWS_AS(scene::load_boxed_packing(in, other), input_error);
  other = small_box();
  other.sizes = {{1e-3, 1.0}};
  CHECK_THROWS_AS(scene::load_boxed_packing(in, other), input_error);
}

TEST_CASE("a cohesive sample without meaning is refused before anything is built") {
  const auto refused = [](auto change) {
    auto p = small_test();
    change(p);
    CHECK_THROWS_AS(scene::cohesive_sample(p, wet_contact, walls, water), input_error);
  };
  const auto unpacked = [](auto change) {
    auto p = small_box();
    change(p);
    CHECK_THROWS_AS(scene::box_packing(p, smooth, walls), input_error);
  };
  for (const double bad : {-1.0, std::nan("")}) {
    refused([&](auto& p) { p.water_content = bad; });
    refused([&](auto& p) { p.confining_pressure = bad; });
    refused([&](auto& p) { p.relaxation = bad; });
    refused([&](auto& p) { p.unbalanced_force = bad; });
    refused([&](auto& p) { p.stress_tolerance = bad; });
    refused([&](auto& p) { p.sample_interval = bad; });
    refused([&](auto& p) { p.mass_scaling = bad; });
    unpacked([&](auto& p) { p.pressure = bad; });
    unpacked([&](auto& p) { p.agitation = bad; });
    unpacked([&](auto& p) { p.compaction = bad; });
    unpacked([&](auto& p) { p.unbalanced_force = bad; });
    unpacked([&](auto& p) { p.density = bad; });
  }
  refused([](auto& p) { p.water_content = 0; });
  for (const double no_steps : {1e-9, 1e300}) {
    refused([&](auto& p) { p.relaxation = no_steps; });
    unpacked([&](auto& p) { p.compaction = no_steps; });
    unpacked([&](auto& p) { p.time_step = no_steps == 1e-9 ? 1e300 : 1e-300; });
  }
  refused([](auto& p) { p.selection.thinning = 0.5; });
  refused([](auto& p) { p.selection.widest_gap = std::nan(""); });
  refused([](auto& p) { p.selection.film_thickness = -1; });
  unpacked([](auto& p) { p.grains = 0; });
}

TEST_CASE("what is no packing is refused, and the sample can still be filled with one") {
  scene::cohesive_sample sample(small_test(), wet_contact, walls, water);
  const auto refused = [&](auto change) {
    auto p = dense();
    change(p);
    CHECK_THROWS_AS(sample.start(p), input_error);
    CHECK(sample.sample().particles().size() == 0);
  };
  refused([](auto& p) { p.grains.clear(); });
  refused([](auto& p) { p.grains[5].radius = std::nan(""); });
  refused([](auto& p) { p.grains[5].density = 0; });
  refused([](auto& p) { p.grains[5].position.y = std::numeric_limits<double>::infinity(); });
  refused([](auto& p) { p.room.upper.z = std::nan(""); });
  refused([](auto& p) { std::swap(p.room.lower, p.room.upper); });
  CHECK_NOTHROW(sample.start(dense()));
  CHECK_THROWS_AS(sample.start(dense()), input_error);
  CHECK(sample.sample().particles().size() == dense().grains.size());
}

TEST_CASE("a checkpoint of a box with other grains, and a file with a broken packing, are refused") {
  const scratch::folder folder;
  auto p = small_box();
  p.compaction = 300 * p.time_step;
  scene::box_packing first(p, smooth, walls);
  scene::monitor watch;
  watch.checkpoint = folder / "state", watch.checkpoint_interval = 100;
  first.run(watch);
  auto other = p;
  other.grains += 1;
  scene::box_packing second(other, smooth, walls);
  CHECK_THROWS_AS(second.resume(io::checkpoint_reader(folder / "state")), input_error);
  CHECK(second.sample().particles().size() == 0);
  auto broken = dense();
  broken.grains[4].position.x = std::nan("");
  scene::write(broken, folder / "broken");
  CHECK_THROWS_AS(scene::load_boxed_packing(io::checkpoint_reader(folder / "broken"), small_box()), input_error);
}
