// SPDX-License-Identifier: BSD-3-Clause
// A packing of 60 grains and its compression, in short durations: all stages, and the promise of the checkpoints.
#include "../catch.hpp"
#include "../io/scratch.hpp"
#include "checkpoints.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/scene/simple_compression.hpp>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace pendular;

namespace {
namespace fs = std::filesystem;

const material smooth{normal::linear{1e3}, damping::viscous{0.8}};
const material rough{normal::linear{1e3}, damping::viscous{0.8}, friction::viscous_coulomb{1.0, 0.4}, energy_book{}};

scene::packing_parameters small_packing() {
  scene::packing_parameters p;
  p.grains = 60;
  p.cylinder_radius = 2.8e-3;
  p.deposition = 0.06;
  p.sealing = 0.04;
  p.time_step = 4e-6;
  return p;
}

scene::compression_parameters small_test() {
  scene::compression_parameters p{.area = small_packing().area()};
  p.relaxation = 8e-3;
  p.duration = 0.024;
  p.lid_speed = 5e-3;
  p.time_step = 4e-6;
  p.sample_interval = 4e-4;
  return p;
}

template <class Protocol>
auto wet_by(Protocol protocol) {
  return liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol};
}

const scene::sealed_packing& packed() {
  static const scene::sealed_packing done = scene::packing(small_packing(), smooth, smooth).run({});
  return done;
}

std::vector<double> numbers_of(const scene::sealed_packing& p) {
  std::vector<double> all{p.height, p.solid_fraction, p.solid_mass};
  for (const grain& g : p.grains)
    all.insert(all.end(), {g.position.x, g.position.y, g.position.z, g.radius, g.density});
  return all;
}

template <class Test>
std::vector<double> numbers_of(const Test& test) {
  std::vector<double> all;
  for_each_number(test.result(), [&](const double& v) { all.push_back(v); });
  const auto& g = test.sample().particles();
  for (const std::size_t row : g.rows_by_id()) {
    for (const vector& v : {g.template get<column::position>()[row], g.template get<column::velocity>()[row],
                            g.template get<column::angular_velocity>()[row], g.template get<column::force>()[row]}) {
      all.insert(all.end(), {v.x, v.y, v.z});
    }
    all.push_back(test.sample().bridges().book().films()[row]);
  }
  const auto& book = test.sample().bridges().book();
  all.insert(all.end(), {book.total(), static_cast<double>(test.sample().bridges().count()),
                         static_cast<double>(test.sample().events().ruptures)});
  return all;
}
}  // namespace

TEST_CASE("sixty grains are deposited and sealed") {
  const auto& p = packed();
  REQUIRE(p.grains.size() == 60);
  CHECK((p.solid_fraction > 0.4 && p.solid_fraction < 0.65));  // of a narrow cylinder
  double volume = 0;
  for (const grain& g : p.grains) {
    volume += 4.0 / 3 * std::numbers::pi * g.radius * g.radius * g.radius;
    CHECK(std::hypot(g.position.x, g.position.y) + g.radius < 2.8e-3 * 1.001);
    CHECK(g.position.z > 0.99 * g.radius);
    CHECK(g.position.z + g.radius < p.height * 1.001);
  }
  CHECK(p.solid_mass == within(1e-12, 2700 * volume));
  CHECK(p.solid_fraction == within(1e-12, volume / (small_packing().area() * p.height)));
}

TEST_CASE("the relaxation has a line an interval, and the last one is the state before the test") {
  scene::simple_compression test(small_test(), rough, wet_by(protocol::homogeneous{1000}));
  test.start(packed());
  const auto r = test.run({});
  REQUIRE(r.relaxation.size() == 20);  // 8 ms by 0.4 ms
  for (std::size_t k = 0; k < 20; ++k) {
    CHECK(r.relaxation[k].time == within(1e-12, 4e-4 * static_cast<double>(k + 1)));
    CHECK(r.relaxation[k].bridges > 2);
  }
  const auto& last = r.relaxation.back();
  CHECK((last.surface_settlement == r.surface_settlement && last.centre_settlement == r.centre_settlement));
  CHECK(last.bridges == r.relaxed_bridges);
  CHECK(last.centre_settlement != r.relaxation.front().centre_settlement);
}

TEST_CASE("a packing that is sealed for longer is hardly lower") {
  auto longer = small_packing();
  longer.sealing = 0.2;
  const auto p = scene::packing(longer, smooth, smooth).run({});
  CHECK(std::abs(p.height - packed().height) < 0.03 * p.height);
}

TEST_CASE("a packing that is resumed from any checkpoint of any stage ends with the same bits") {
  const scratch::folder folder;
  std::vector<fs::path> kept;
  const auto uninterrupted =
      numbers_of(scene::packing(small_packing(), smooth, smooth).run(checkpoints::watching(folder, 3000, kept)));
  std::set<std::string> stages;
  REQUIRE(kept.size() > 4);
  for (const fs::path& from : kept) {
    stages.insert(checkpoints::stage_in(from));
    scene::packing again(small_packing(), smooth, smooth);
    again.resume(io::checkpoint_reader(from));
    CAPTURE(from.filename().string());
    CHECK((numbers_of(again.run(checkpoints::written_to(folder / "again", 3000))) == uninterrupted));
  }
  CHECK(stages.size() == 2);
}

TEST_CASE("a sealed packing is read as it was written") {
  const scratch::folder folder;
  io::checkpoint_writer out(folder / "packing");
  scene::save(out, packed());
  out.commit();
  const io::checkpoint_reader in(folder / "packing");
  CHECK((numbers_of(scene::load_packing(in)) == numbers_of(packed())));
  CHECK((numbers_of(scene::load_packing(in, small_packing())) == numbers_of(packed())));
  CHECK(packed().cylinder_radius == small_packing().cylinder_radius);
}

TEST_CASE("a packing with half a grain is refused") {
  const scratch::folder folder;
  for (const std::size_t entries : {3u, 8u}) {
    io::checkpoint_writer out(folder / "packing");
    out.put("packing.numbers", std::vector<double>(entries, 1.0));
    out.commit();
    CHECK_THROWS_AS(scene::load_packing(io::checkpoint_reader(folder / "packing")), std::runtime_error);
  }
}

TEST_CASE("a packing of other grains or of another cylinder than wanted is refused") {
  const scratch::folder folder;
  scene::write(packed(), folder / "packing");
  const io::checkpoint_reader in(folder / "packing");
  const auto refused = [&](auto change) {
    auto p = small_packing();
    change(p);
    CHECK_THROWS_AS(scene::load_packing(in, p), input_error);
  };
  refused([](auto& p) { p.grains += 1; });
  refused([](auto& p) { p.cylinder_radius *= 2; });
  refused([](auto& p) { p.sizes = scene::shear_grading(); });
}

TEMPLATE_TEST_CASE("a small compression runs through its stages and resumes from each with the same bits", "",
                   protocol::homogeneous, protocol::grain_films, protocol::neighbours, protocol::gravity) {
  const auto water = wet_by(TestType{});
  const scratch::folder folder;
  std::vector<fs::path> kept;
  scene::simple_compression test(small_test(), rough, water);
  test.start(packed());
  test.run(checkpoints::watching(folder, 600, kept));
  const auto& r = test.result();
  REQUIRE(r.records.size() == 60);
  CHECK(r.records.back().time == within(1e-9, 0.024));
  CHECK(r.records.back().shortening == within(1e-9, 0.024 * 5e-3));
  CHECK(r.initial_bridges > 2);
  CHECK(r.reference.size() == 60);
  for (const auto& line : r.records) {
    REQUIRE(std::isfinite(line.stress + line.imbalance));
    CHECK(line.liquid == near(1e-12, 1.0));
    CHECK(line.bridges > 0);
  }
  // The book closes but for the liquid laws' jumps, at most a few per cent of what went through.
  CHECK(std::abs(r.records.back().imbalance) < 0.05 * r.records.back().turnover);

  std::set<std::string> stages;
  REQUIRE(kept.size() > 5);
  for (const fs::path& from : kept) {
    stages.insert(checkpoints::stage_in(from));
    scene::simple_compression again(small_test(), rough, water);
    again.resume(io::checkpoint_reader(from));
    again.run(checkpoints::written_to(folder / "again", 600));
    CAPTURE(from.filename().string());
    CHECK((numbers_of(again) == numbers_of(test)));
  }
  CHECK(stages.size() == 2);
}

TEST_CASE("stress on another area than the packing's is refused") {
  auto p = small_test();
  p.area *= 1.01;
  scene::simple_compression test(p, rough, wet_by(protocol::none{}));
  CHECK_THROWS_AS(test.start(packed()), input_error);
}

TEST_CASE("a packing that is none is refused before a grain is in the sample") {
  auto broken = packed();
  broken.grains[3].radius = -broken.grains[3].radius;
  scene::simple_compression test(small_test(), rough, wet_by(protocol::none{}));
  CHECK_THROWS_AS(test.start(broken), input_error);
  broken = packed();
  broken.solid_mass *= 1.01;
  CHECK_THROWS_AS(test.start(broken), input_error);
  CHECK(test.sample().particles().size() == 0);
}

TEST_CASE("a checkpoint of another composition is refused") {
  const scratch::folder folder;
  std::vector<fs::path> kept;
  scene::simple_compression test(small_test(), rough, wet_by(protocol::homogeneous{}));
  test.start(packed());
  test.run(checkpoints::watching(folder, 600, kept));
  scene::simple_compression other(small_test(), rough, wet_by(protocol::gravity{}));
  CHECK_THROWS_AS(other.resume(io::checkpoint_reader(kept.front())), std::runtime_error);
}

TEST_CASE("parameters without meaning are refused before anything is built") {
  auto packing_of = small_packing();
  packing_of.cylinder_radius = 0;
  CHECK_THROWS_AS(scene::packing(packing_of, smooth, smooth), input_error);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    auto p = small_test();
    p.mass_scaling = bad;
    CHECK_THROWS_AS(scene::simple_compression(p, rough, wet_by(protocol::none{})), input_error);
    auto q = small_test();
    q.sample_interval = bad;
    CHECK_THROWS_AS(scene::simple_compression(q, rough, wet_by(protocol::none{})), input_error);
  }
  auto soaked = small_test();
  soaked.water_content = 1;
  auto thinned = soaked;
  thinned.water_content = 0.02, thinned.selection.thinning = 0.5;
  CHECK_THROWS_AS(scene::simple_compression(thinned, rough, wet_by(protocol::none{})), input_error);
  CHECK_THROWS_AS(scene::simple_compression(soaked, rough, wet_by(protocol::none{})), input_error);
}
