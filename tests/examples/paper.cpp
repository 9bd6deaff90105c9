// SPDX-License-Identifier: BSD-3-Clause
// What the figures of the paper are made from: folders of finished jobs, here written by hand.
#include "../catch.hpp"

#include "../../examples/06_paper/convergence.hpp"
#include "../../examples/06_paper/curves.hpp"
#include "../../examples/06_paper/loci.hpp"
#include "../../examples/06_paper/run.hpp"
#include "../io/scratch.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A job that ended, as far as its readers look.
void write_job(const fs::path& folder, const std::string& options, double stress, double time,
               const std::vector<double>& curve = {}, double plane = 500) {
  fs::create_directories(folder);
  std::ofstream(folder / "summary.json")
      << R"({"options": ")" << options << R"(", "strength": {"residual_shear_stress_Pa": )" << stress
      << R"(, "peak_stress_Pa": )" << stress << R"(, "normal_stress_Pa": )" << plane - 200 << R"(, "plane_stress_Pa": )"
      << plane << R"(, "peak_shear_stress_Pa": null}, "sample": {"bridges_per_grain_start": 6, "radii": [1, 2.5]},)"
      << R"("cost": {"processor_s_per_step": )" << time << R"(}, "energy": {"relative_imbalance": -1e-4}})";
  std::ofstream table(folder / "shear_curve.csv");
  table << "displacement_over_mean_diameter,shear_stress_Pa\n";
  for (std::size_t k = 0; k < curve.size(); ++k) table << 0.5 * static_cast<double>(k) << ',' << curve[k] << '\n';
}

std::string options_of(const std::string& step, int seed) {
  return "duration 1 time-step " + step + " seed " + std::to_string(seed);
}

}  // namespace

TEST_CASE("a run knows its numbers and the options it was given") {
  const scratch::folder folder;
  write_job(folder / "a", "water-content 0.01 packing  grains 100 seed 3", 250, 1);
  const paper::run r(folder / "a");
  CHECK(r.number("strength", "residual_shear_stress_Pa") == 250);
  CHECK(r.number("sample", "radii", 1) == 2.5);
  CHECK(std::isnan(r.number("strength", "peak_shear_stress_Pa")));
  CHECK_THROWS_AS(r.number("strength", "colour"), std::runtime_error);
  CHECK(r.option("grains") == "100");
  CHECK(r.numeric_option("water-content") == 0.01);
  CHECK(r.numeric_option("seed") == 3);
  CHECK_THROWS_AS(r.option("content"), std::runtime_error);
  CHECK_THROWS_AS(paper::run(folder / "b"), std::runtime_error);
}

TEST_CASE("cases are folders of seeds, those that have not ended left out") {
  const scratch::folder folder;
  for (const char* name : {"s800/seed2", "s800/seed1", "s300/seed1"}) write_job(folder / name, "seed 1", 1, 1);
  fs::create_directories(folder / "s300/seed2");
  fs::create_directories(folder / "s550/seed1");
  const auto found = paper::cases(fs::path(folder / "s300").parent_path());
  REQUIRE(found.size() == 2);
  CHECK((found[0].first == "s300" && found[1].first == "s800"));
  CHECK((found[0].second.size() == 1 && found[1].second.size() == 2));
  CHECK(found[1].second[0].folder().filename() == "seed1");
  CHECK_THROWS_AS(paper::runs_of(folder / "s550"), std::runtime_error);
  CHECK(paper::cases(folder / "nowhere").empty());
}

TEST_CASE("a drop is a fall between a line of the curve and the second after it, beyond one diameter") {
  const scratch::folder folder;
  // x = 0, 0.5, 1, ... 4; mean beyond one diameter 94; falls of 40 in two lines at x = 1.5, of 10 in one line at 3
  write_job(folder / "a", "seed 1", 1, 1, {10, 200, 100, 110, 90, 70, 100, 100, 90, 98});
  const paper::run r(folder / "a");
  CHECK(paper::drops_per_diameter(r, 0.2) == within(1e-12, 1 / 3.5));
  CHECK(paper::drops_per_diameter(r, 0.05) == within(1e-12, 2 / 3.5));
  CHECK(paper::drops_per_diameter(r, 0.5) == 0);
}

TEST_CASE("the mean of curves reaches as far as the shortest") {
  const scratch::folder folder;
  write_job(folder / "c/seed1", "seed 1", 1, 1, {0, 10, 20, 30});
  write_job(folder / "c/seed2", "seed 2", 1, 1, {2, 14, 20});
  const auto mean = paper::mean_curve(paper::runs_of(folder / "c"));
  CHECK(mean.x == std::vector<double>{0, 0.5, 1});
  CHECK(mean.y == std::vector<double>{1, 12, 20});
  CHECK(paper::mean_between(mean, 0.4, 1) == 16);
}

TEST_CASE("means over seeds have standard errors") {
  const auto m = paper::mean_of({1, 2, 3, 6});
  CHECK(m.mean == 3);
  CHECK(m.error == within(1e-12, std::sqrt(14.0 / 3 / 4)));
  CHECK(std::isnan(paper::mean_of({1}).error));
  CHECK(std::isnan(paper::mean_of({}).mean));
}

TEST_CASE("a locus has the mean of the lines of its seeds") {
  const scratch::folder folder;
  // over the plane: seed 1 has cohesion 50 and tangent 0.5, seed 2 70 and 0.5; seed 3 lacks a stress
  for (const int seed : {1, 2, 3}) {
    for (const double plane : {400.0, 800.0}) {
      if (seed == 3 && plane > 500) continue;
      const auto where = folder / ("s" + std::to_string(static_cast<int>(plane))) / ("seed" + std::to_string(seed));
      write_job(where, "seed " + std::to_string(seed), 30 + 20 * seed + 0.5 * plane, 1, {}, plane);
    }
  }
  const std::vector<paper::seeds> all{paper::runs_of(folder / "s400"), paper::runs_of(folder / "s800")};
  const auto l = paper::locus_of(all);
  CHECK(l.intercept().mean == within(1e-12, 160));  // the lid has 200 Pa less
  CHECK(l.intercept().error == within(1e-9, 10));
  CHECK(l.tan_friction().mean == within(1e-12, 0.5));
  CHECK(l.lid_angle().mean == within(1e-12, 26.565051177077990));
  CHECK(l.plane_angle().mean == within(1e-12, 26.565051177077990));
  REQUIRE(l.lines.size() == 2);
  CHECK(l.lines[1].over_plane.cohesion == within(1e-12, 70));
  CHECK(l.lines[1].mean_shear == within(1e-12, 370));
  CHECK(l.lid.size() == 4);
  CHECK(l.bridges.mean == 6);
  auto dry = l;
  dry.lines[0].over_lid.cohesion -= 100, dry.lines[1].over_lid.cohesion -= 120;
  dry.lines[0].mean_shear -= 50, dry.lines[1].mean_shear -= 70;
  CHECK(paper::added_intercept(l, dry).mean == within(1e-12, 110));
  CHECK(paper::added_shear_stress(l, dry).mean == within(1e-12, 60));
  CHECK(paper::added_shear_stress(l, dry).error == within(1e-12, 10));
  dry.lines[0].seed = "7";
  CHECK(paper::added_shear_stress(l, dry).mean == within(1e-12, 70));
  CHECK_THROWS(paper::locus_of({all[0]}));
}

TEST_CASE("runs are compared with those of their seed") {
  const scratch::folder folder;
  for (const int seed : {1, 2, 3}) {
    const auto name = "seed" + std::to_string(seed), options = "seed " + std::to_string(seed);
    write_job(folder / "a" / name, options, 10 * seed, 1);
    if (seed != 2) write_job(folder / "b" / name, options, seed, 1);
  }
  const auto stress = [](const paper::run& r) { return r.number("strength", "peak_stress_Pa"); };
  const auto found = paper::by_seed(paper::runs_of(folder / "a"), paper::runs_of(folder / "b"),
                                    [&](const paper::run& a, const paper::run& b) { return stress(a) - stress(b); });
  CHECK(found == std::vector<double>{9, 27});
}

TEST_CASE("a study compares by seed with its finest setting") {
  const scratch::folder folder;
  const auto shear = folder / "shear", compression = folder / "compression";
  for (const int seed : {1, 2}) {
    const auto name = "seed" + std::to_string(seed);
    const auto options = [&](const char* step) { return options_of(step, seed); };
    write_job(shear / "reference/reference" / name, options("4e-6"), 100 + 10 * seed, 2);
    write_job(compression / "reference/reference" / name, options("4e-6"), 1, 1);
    write_job(shear / "time_step/1e-6" / name, options("9.9999999999999995e-07"), 90 + 11 * seed, 2);
    write_job(shear / "time_step/7e-6" / name, options("7e-6"), 120, 1.75);
  }
  write_job(shear / "skin/0.05/seed1", options_of("4e-6", 1), 110, 3);
  const auto studies = paper::convergence::read(fs::path(shear).parent_path(), "shear");
  REQUIRE(studies.size() == 2);
  CHECK(studies[1].points[0].value == "0.05");  // not among the options that decide results
  CHECK(studies[1].points[0].time == 1.5);
  const auto& points = studies[0].points;
  REQUIRE(points.size() == 3);
  CHECK(points[0].stress.mean == 106.5);
  CHECK((points[0].change.mean == 0 && points[0].time == 4));
  // differences 110 - 101 and 120 - 112
  CHECK(points[1].change.mean == within(1e-12, 8.5 / 106.5));
  CHECK(points[1].change.error == within(1e-12, 0.5 / 106.5));
  CHECK(points[2].time == 0.5);
  CHECK(points[2].worst_book == 1e-4);
  const auto text = paper::convergence::table_of(studies, "shear");
  CHECK(text.find("| 1e-06 | 106.5 ± 5.5 | finest | 4.00 | 1e-04 |") != std::string::npos);
}
