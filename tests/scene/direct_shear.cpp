// SPDX-License-Identifier: BSD-3-Clause
// A shear cell of 150 grains, in short durations: stages, balance of forces and energy, the promise of the checkpoints.
#include "../catch.hpp"
#include "../io/scratch.hpp"
#include "checkpoints.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/scene/direct_shear.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <vector>

using namespace pendular;

namespace {
using contact = material<normal::linear, damping::viscous, friction::coulomb_spring, energy_book>;

contact with_friction(double coefficient) {
  return material{normal::linear{1e3}, damping::viscous{0.8}, friction::coulomb_spring{800, coefficient},
                  energy_book{}};
}
const scene::shear_materials<contact> smooth_cell{with_friction(0), with_friction(0.4), with_friction(0),
                                                  with_friction(0)};
const scene::shear_materials<contact> rough_cell{with_friction(0), with_friction(0.4), with_friction(0.4),
                                                 with_friction(0.4)};
const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}};

constexpr double cell_radius = 5.5e-3;  // m

const scene::sealed_packing& deposited() {
  scene::packing_parameters p;
  p.grains = 150;
  p.sizes = scene::shear_grading();
  p.cylinder_radius = cell_radius;
  p.deposition = 0.15;
  p.sealing = 0;
  p.time_step = 1e-5;
  const material smooth{normal::linear{1e3}, damping::viscous{0.8}};
  static const scene::sealed_packing done = scene::packing(p, smooth, smooth).run({});
  return done;
}

scene::shear_parameters small_test() {
  scene::shear_parameters p;
  p.cell_radius = cell_radius;
  p.consolidation = 0.05;
  p.rest = 0.02;
  p.shear_speed = 10e-3;
  p.displacement = 0.4e-3;
  return p;
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

/// Mean over the second half of the curve.
template <class Value>
double later_mean(const scene::shear_result& r, const Value& value) {
  double sum = 0;
  for (std::size_t k = r.records.size() / 2; k < r.records.size(); ++k) sum += value(r.records[k]);
  return sum / static_cast<double>(r.records.size() - r.records.size() / 2);
}

struct balance {
  double lid, plane, shear;  // means over the second half of the curve, Pa
  double above;              // weight of the grains above the plane, Pa
  double drift;              // what floor and lower half bear along x less what drives, over the latter
};

balance balance_of(const scene::shear_parameters& p, const scene::shear_materials<contact>& cell) {
  scene::direct_shear test(p, cell, dry{});
  test.start(deposited());
  double across = 0, seen = 0, above = 0;
  test.look = [&](const auto& s, const scene::shear_result& r) {
    if (r.records.size() < 20) return;
    across += boundary::get<0>(s.walls()).force.x + boundary::get<1>(s.walls()).force.x -
              r.records.back().stress.shear * p.area();
    above = 0;
    const auto& g = s.particles();
    for (std::size_t row = 0; row < g.size(); ++row) {
      const double mass = 1 / g.template get<column::inverse_mass>()[row] / p.mass_scaling;
      if (g.template get<column::position>()[row].z >= r.sample.split_height) above += 9.81 * mass;
    }
    ++seen;
  };
  const scene::shear_result r = test.run({});
  REQUIRE(r.records.size() >= 40);
  REQUIRE(seen >= 21);
  const double shear = later_mean(r, [](const auto& line) { return line.stress.shear; });
  return {later_mean(r, [](const auto& line) { return line.stress.lid; }),
          later_mean(r, [](const auto& line) { return line.stress.plane; }), shear, above / p.area(),
          across / seen / (shear * p.area())};
}
}  // namespace

TEST_CASE("a sample without a lid keeps the height of its highest grain") {
  const auto& p = deposited();
  REQUIRE(p.grains.size() == 150);
  double top = 0;
  for (const grain& g : p.grains) top = std::max(top, g.position.z + g.radius);
  CHECK(p.height == within(1e-12, top));
}

TEST_CASE("the diameters of the shear sample are those of the paper, by number") {
  const auto all = scene::diameters(scene::shear_grading(), 7307, 1);
  const auto count = [&](double d) { return std::count(all.begin(), all.end(), d); };
  CHECK((count(2e-3) == 3654 && count(1.5e-3) == 2192 && count(1e-3) == 1461));
  CHECK(scene::mean_diameter(scene::shear_grading()) == within(1e-12, 1.65e-3));
  double volume = 0;
  for (const double d : all) volume += std::numbers::pi / 6 * d * d * d;
  CHECK(volume == within(1e-3, 19943e-9));  // 20 mm high at a solid fraction of 0.6 in the cell of 46 mm
}

TEST_CASE("lid, plane between the halves and the drive balance what the grains weigh and bear") {
  auto p = small_test();
  SECTION("grains as they are") {}
  SECTION("inertia times four: weights and stresses stay") {
    p.mass_scaling = 4;
    p.time_step *= 2;
  }
  const balance smooth = balance_of(p, smooth_cell);
  CHECK(smooth.lid == within(0.05, 300));                          // and its dashpot
  CHECK(smooth.plane == within(0.05, smooth.lid + smooth.above));  // nothing hangs on a smooth wall
  CHECK(std::abs(smooth.drift) < 0.05);                            // what drives the upper half, the lower half bears
  CHECK((smooth.shear > 0.15 * smooth.plane && smooth.shear < 1.2 * smooth.plane));
  const balance rough = balance_of(p, rough_cell);
  CHECK(rough.lid == within(0.05, 300));
  CHECK(std::abs(rough.drift) < 0.05);  // the lid drives, too
}

TEST_CASE("the work of upper half and lid is that of their stresses, and the energy book closes") {
  scene::direct_shear test(small_test(), rough_cell, water);
  test.start(deposited());
  double before = 0, work = 0;
  test.look = [&](const auto& s, const scene::shear_result& r) {
    work = boundary::get<2>(s.walls()).work + boundary::get<3>(s.walls()).work;
    if (r.records.empty()) before = work;
  };
  const scene::shear_result r = test.run({});
  const double area = small_test().area();
  double expected = 0, height = r.sample.start.height;
  for (const auto& line : r.records) {
    expected += line.stress.shear * area * 1e-5 - line.stress.lid * area * (line.height - height);
    height = line.height;
  }
  CHECK(work - before == within(0.08, expected));
  for (const auto& line : r.records) {
    REQUIRE(std::isfinite(line.stress.shear));
    CHECK(line.liquid == near(1e-12, 1.0));
    CHECK(std::abs(line.energy.imbalance) < 0.05 * line.energy.turnover);
  }
}

TEST_CASE("consolidation ends at the solid fraction that is wanted, or with its time") {
  auto p = small_test();
  p.displacement = 1e-5;
  p.solid_fraction = 0.3;  // is there from the start
  scene::direct_shear loose(p, rough_cell, dry{});
  loose.start(deposited());
  const auto at_once = loose.run({}).sample;
  CHECK(at_once.consolidation_time == 0);
  p.solid_fraction = 0.73;  // is never reached
  scene::direct_shear dense(p, rough_cell, dry{});
  dense.start(deposited());
  const auto sample = dense.run({}).sample;
  CHECK(sample.consolidation_time == within(1e-3, 0.05));
  CHECK(sample.solid_fraction > 0.4);
  CHECK(sample.split_height < 0.51 * sample.deposited_height);
  p.solid_fraction = 0.5 * (at_once.solid_fraction + sample.solid_fraction);
  scene::direct_shear between(p, rough_cell, dry{});
  between.start(deposited());
  const double reached = between.run({}).sample.solid_fraction;
  CHECK((reached >= p.solid_fraction && reached < p.solid_fraction + 2e-5));  // in the first step that is dense enough
}

TEST_CASE("a sample has its density, its bridges and nearly no shear stress when the upper half starts") {
  auto p = small_test();
  p.displacement = 1e-5;
  scene::direct_shear test(p, rough_cell, water);
  test.start(deposited());
  const auto r = test.run({});
  const auto& start = r.sample.start;
  double solid = 0;
  for (const grain& g : deposited().grains) solid += 4.0 / 3 * std::numbers::pi * std::pow(g.radius, 3);
  // overlaps with the walls are counted once, as what is in the cell
  CHECK(start.density.cell == within(2e-3, solid / (p.area() * start.height)));
  CHECK(start.density.near_walls > 0.3);
  CHECK(start.bridges > 3);
  CHECK(std::abs(start.shear_stress) < 0.2 * p.normal_stress);
  CHECK(start.height < r.sample.deposited_height);
}

TEST_CASE("a packing for another cell is refused") {
  auto p = small_test();
  p.cell_radius = 1.1 * cell_radius;
  scene::direct_shear test(p, rough_cell, dry{});
  CHECK_THROWS_AS(test.start(deposited()), input_error);
}

TEST_CASE("a packing that is none is refused before a grain is in the cell") {
  auto broken = deposited();
  broken.grains[3].position.z = -1;
  scene::direct_shear test(small_test(), rough_cell, dry{});
  CHECK_THROWS_AS(test.start(broken), input_error);
  CHECK(test.sample().particles().size() == 0);
}

TEMPLATE_TEST_CASE("a direct shear that is resumed from any checkpoint of any stage ends with the same bits", "",
                   std::true_type, std::false_type) {
  const auto substance = [] {
    if constexpr (TestType::value) return water;
    else return dry{};
  }();
  const scratch::folder folder;
  std::vector<std::filesystem::path> kept;
  scene::direct_shear test(small_test(), rough_cell, substance);
  test.start(deposited());
  test.run(checkpoints::watching(folder, 2600, kept));
  std::set<std::string> stages;
  REQUIRE(kept.size() > 5);
  for (const auto& from : kept) {
    stages.insert(checkpoints::stage_in(from));
    scene::direct_shear again(small_test(), rough_cell, substance);
    again.resume(io::checkpoint_reader(from));
    again.run(checkpoints::written_to(folder / "again", 2600));
    CAPTURE(from.filename().string());
    CHECK((numbers_of(again) == numbers_of(test)));
  }
  CHECK(stages.size() == 3);
}

TEST_CASE("a shear test without meaning is refused before anything is built") {
  const auto refused = [](auto change) {
    auto p = small_test();
    change(p);
    CHECK_THROWS_AS(scene::direct_shear(p, rough_cell, dry{}), input_error);
  };
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    refused([&](auto& p) { p.normal_stress = bad; });
    refused([&](auto& p) { p.shear_speed = bad; });
    refused([&](auto& p) { p.displacement = bad; });
    refused([&](auto& p) { p.solid_fraction = bad; });
  }
  refused([](auto& p) { p.gravity = std::nan(""); });
  refused([](auto& p) { p.displacement = cell_radius; });
  refused([](auto& p) { p.displacement = 1e-9; });  // less than a step
  refused([](auto& p) { p.water_content = 1; });
  refused([](auto& p) { p.selection.widest_gap = -1; });
}
