// SPDX-License-Identifier: BSD-3-Clause
// What the figures of the paper are made from: folders of finished jobs, here written by hand.
#include "../catch.hpp"

#include "../../examples/06_paper/cohesion.hpp"
#include "../../examples/06_paper/companion.hpp"
#include "../../examples/06_paper/convergence.hpp"
#include "../../examples/06_paper/curves.hpp"
#include "../../examples/06_paper/loci.hpp"
#include "../../examples/06_paper/run.hpp"
#include "../io/scratch.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A job that ended, as far as its readers look. Every line of its curve has values of its own: a line at x is 10 x beyond
/// `plane`, and has 5 + x bridges.
void write_job(const fs::path& folder, const std::string& options, double stress, double time,
               const std::vector<double>& curve = {}, double plane = 500) {
  fs::create_directories(folder);
  std::ofstream(folder / "summary.json")
      << R"({"options": ")" << options << R"(", "strength": {"residual_shear_stress_Pa": )" << stress
      << R"(, "peak_stress_Pa": )" << stress
      << R"(, "peak_shear_stress_Pa": null, "of_kind": {"alpha": 4.5}}, "sample": {"bridges_per_grain_start": 6, "radii": [1, 2.5], "mean_diameter_m": 1e-3,)"
      << R"("solid_fraction": 0.6, "split_height_m": 0.01, "shear_stress_start_Pa": 7},)"
      << R"("cost": {"processor_s_per_step": )" << time << R"(}, "energy": {"relative_imbalance": -1e-4}})";
  std::ofstream table(folder / "shear_curve.csv");
  table << "displacement_over_mean_diameter,shear_stress_Pa,lid_stress_Pa,plane_stress_Pa,bridges_per_grain,height_m,"
           "shared_area_over_cell\n";
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double x = 0.5 * static_cast<double>(k);
    table << x << ',' << curve[k] << ',' << 300 + x << ',' << plane + 10 * x << ',' << 5 + x << ',' << 0.02 + x / 1000
          << ',' << 1 - x / 10 << '\n';
  }
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
  CHECK(r.number("strength", "of_kind", "alpha") == 4.5);
  CHECK_THROWS_AS(r.number("strength", "of_kind", "beta"), std::runtime_error);
  CHECK(std::isnan(r.number("strength", "peak_shear_stress_Pa")));
  CHECK_THROWS_AS(r.number("strength", "colour"), std::runtime_error);
  CHECK(r.option("grains") == "100");
  CHECK(r.numeric_option("water-content") == 0.01);
  CHECK(r.numeric_option("seed") == 3);
  CHECK_THROWS_AS(r.option("content"), std::runtime_error);
  CHECK_THROWS_AS(paper::run(folder / "b"), std::runtime_error);
  std::ofstream(folder / "a/summary.json") << "{";
  CHECK_THROWS_AS(paper::run(folder / "a"), std::runtime_error);
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

TEST_CASE("a fall of the stress counts once, beyond one diameter") {
  const scratch::folder folder;
  // x = 0, 0.5, ... 4.5: beyond one diameter falls of 40 in two lines, then of 10 in one
  write_job(folder / "a", "seed 1", 1, 1, {10, 200, 100, 110, 90, 70, 100, 100, 90, 98});
  const paper::run r(folder / "a");
  CHECK(paper::falls_per_diameter(r, 9) == within(1e-12, 2 / 3.5));
  CHECK(paper::falls_per_diameter(r, 19) == within(1e-12, 1 / 3.5));
  CHECK(paper::falls_per_diameter(r, 39) == within(1e-12, 1 / 3.5));
  CHECK(paper::falls_per_diameter(r, 40) == 0);
}

TEST_CASE("a shear test has means over a stretch and about its peak") {
  const scratch::folder folder;
  write_job(folder / "a", "water-content 0.02 seed 1", 1, 1, {10, 90, 40, 50, 60, 1000}, 700);
  const paper::run r(folder / "a");
  const auto late = paper::residual_state(r), nominal = paper::residual_state_over_lid_and_weight(r);
  CHECK((late.shear == 50 && late.normal == 715 && late.bridges == 6.5 && late.height == within(1e-12, 0.0215)));
  CHECK(late.shared == within(1e-12, 0.85));
  CHECK((nominal.shear == 50 && nominal.bridges == 6.5));
  CHECK(nominal.normal == within(1e-12, 301.5 + 0.6 * 2700 * 1.02 * 9.81 * 0.01));
  CHECK_THROWS_AS(paper::state_between(r, 2, 4), std::runtime_error);
  write_job(folder / "b", "seed 1", 1, 1, {10, 90, 40, 50, 60}, 700);
  const auto peak = paper::peak_state(paper::run(folder / "b"));
  CHECK((peak.shear == 90 && peak.normal == 705 && peak.bridges == 5.5));
}

TEST_CASE("a shear curve begins with what the sample bears at rest, and has a summit over its residual stress") {
  const scratch::folder folder;
  fs::create_directories(folder / "a");
  write_job(folder / "a", "seed 1", 1, 1);
  std::ofstream(folder / "a/shear_curve.csv")
      << "displacement_over_mean_diameter,shear_stress_Pa\n0.5,90\n1,60\n2,40\n";
  const paper::run r(folder / "a");
  const auto c = paper::stress_curve(r);
  CHECK(c.x == std::vector<double>{0, 0.5, 1, 2});
  CHECK(c.y == std::vector<double>{7, 90, 60, 40});
  CHECK(paper::summit_over_residual(r) == within(1e-12, 90.0 / 50));
  CHECK(paper::early_over_residual(r) == within(1e-12, 90.0 / 50));
}

TEST_CASE("a summit at the end of a curve is a lower bound") {
  const auto top = paper::summit_of({{0, 1, 2}, {5, 10, 7}});
  CHECK((top.at == 1 && top.stress == 10 && !top.rising));
  CHECK(paper::summit_of({{0, 1, 2}, {5, 9, 10}}).rising);
  CHECK(!paper::summit_of({{0, 1, 2}, {5, 10, 9.9}}).rising);
}

TEST_CASE("what a sample that springs back presses at first is no summit") {
  const auto top = paper::summit_of({{0, 0.03, 0.06, 1, 2}, {500, 300, 8, 10, 7}});
  CHECK((top.at == 1 && top.stress == 10));
  CHECK_THROWS_AS(paper::summit_of({{0, 0.01}, {1, 2}}), std::runtime_error);
}

TEST_CASE("a curve has no mean where it has not been") {
  const paper::xy curve{{0, 0.5, 1}, {1, 2, 3}};
  CHECK(paper::mean_between(curve, 0.4, 1.2) == 2.5);  // a line is missing at most
  CHECK_THROWS_AS(paper::mean_between(curve, 0, 1.6), std::runtime_error);
  CHECK_THROWS_AS(paper::mean_between({}, 0, 1), std::runtime_error);
}

TEST_CASE("the shortening of a compression counts from where the lid bears the sample") {
  const scratch::folder folder;
  write_job(folder / "a", "seed 1", 1, 1);
  fs::remove(folder / "a/shear_curve.csv");
  std::ofstream(folder / "a/stress_strain.csv") << "shortening_m,axial_stress_Pa\n0,0\n1e-3,2\n2e-3,60\n3e-3,100\n";
  const auto c = paper::stress_curve(paper::run(folder / "a"));
  CHECK(c.x == std::vector<double>{0, 1});
  CHECK(c.y == std::vector<double>{60, 100});
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
  // over the plane, 15 Pa more from one to two diameters: seed 1 has cohesion 50 and tangent 0.5, seed 2 70 and 0.5; seed 3
  // lacks a load
  const auto write = [&](const std::string& group, int seed, double plane, double cohesion) {
    const double stress = cohesion + 0.5 * (plane + 15);
    write_job(folder / (group + std::to_string(static_cast<int>(plane))) / ("seed" + std::to_string(seed)),
              "seed " + std::to_string(seed), 1, 1, {0, 0, stress, stress, stress, 0}, plane);
  };
  for (const int seed : {1, 2, 3}) {
    write("wet", seed, 400, 30 + 20 * seed), write("dry", seed, 400, 3 * seed);
    if (seed < 3) write("wet", seed, 800, 30 + 20 * seed), write("dry", seed, 900, 3 * seed);
  }
  const auto runs = [&](const char* name) { return paper::runs_of(folder / name); };
  const auto l = paper::locus_of({runs("wet400"), runs("wet800")});
  CHECK(l.cohesion().mean == within(1e-12, 60));
  CHECK(l.cohesion().error == within(1e-9, 10));
  CHECK(l.tan_friction().mean == within(1e-12, 0.5));
  CHECK(l.angle().mean == within(1e-12, 26.565051177077990));
  CHECK((l.lines.size() == 2 && l.normal.size() == 4 && l.shear.size() == 4));
  CHECK(l.lines[1].mean.shear == within(1e-12, 377.5));
  CHECK((l.bridges().mean == 6.5 && l.height().mean == within(1e-12, 0.0215)));
  auto dry = paper::locus_of({runs("dry400"), runs("dry900")});
  const auto added = paper::beyond_dry_line(l, dry);  // whatever the loads
  REQUIRE(added.size() == 2);
  CHECK((added[0] == within(1e-12, 47) && added[1] == within(1e-12, 64)));
  CHECK(std::abs(paper::added_angle(l, dry).mean) < 1e-12);
  dry.lines[0].seed = "7";
  CHECK(paper::beyond_dry_line(l, dry).size() == 1);
  CHECK_THROWS(paper::locus_of({runs("wet400")}));
  const auto other = paper::runs_of(folder / "dry900");
  CHECK_THROWS_AS(paper::locus_of({{runs("dry400")[2]}, other}), std::runtime_error);
}

TEST_CASE("Rumpf's estimate has the tangent and the bridges of its locus") {
  const scratch::folder folder;
  for (const int load : {400, 800}) {
    const double stress = 50 + 0.5 * (load + 15);
    write_job(folder / ("s" + std::to_string(load)) / "seed1", "scale 2 kappa 0.4 seed 1", 1, 1,
              {0, 0, stress, stress, stress}, load);
  }
  const auto runs = [&](const char* name) { return paper::runs_of(folder / name); };
  const auto l = paper::locus_of({runs("s400"), runs("s800")});
  // pressure as a third of force times branch over the volume (Love-Weber), summed over the bridges between all sizes
  const std::vector<double> radii{2e-3, 1.5e-3, 1e-3}, shares{0.5, 0.3, 0.2};
  double virial = 0, grain_volume = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    grain_volume += shares[i] * 4.18879020478639 * std::pow(radii[i], 3);
    for (std::size_t j = 0; j < 3; ++j) {
      const double force = 0.4 * std::sqrt(radii[i] * radii[j]);
      virial += 6.5 / 2 * shares[i] * shares[j] * force * (radii[i] + radii[j]);
    }
  }
  const double volume = grain_volume / (0.6 * 0.02 / 0.0215);
  const double expected = 0.5 * virial / 3 / volume;
  CHECK(paper::shear::expected_cohesion(l, runs("s400").front()).mean == within(1e-9, expected));
}

TEST_CASE("samples of the companion paper with three seeds stand below its own numbers") {
  const scratch::folder folder;
  const auto write = [&](const char* name, double z) {
    fs::create_directories(folder / name);
    std::ofstream(folder / name / "summary.json")
        << R"({"options": "seed 1", "end": {"solid_fraction_bulk": 0.6, "bridges_across_gaps_per_grain": 1},)"
        << R"("neighbours": {"all_per_grain": )" << z
        << R"(, "compressive_per_grain": 2, "tensile_per_grain": 3, "rho_compressive_0": 0.1, "rho_tensile_0": 0.2,)"
        << R"("share_with_as_many_of_both": 0.125}, "neighbours_in_the_bulk": {"all_per_grain": 6},)"
        << R"("forces": {"largest_over_f0": 2.04, "compressive": {"alpha": 3.9}, "tensile": {"alpha": null}},)"
        << R"("rest": {"unbalanced_force_ratio": 1e-3}})";
  };
  write("loose-eligible-w0.007/seed1", 5), write("loose-eligible-w0.007/seed2", 6);
  write("dense-touching-w0.007/seed1", 1);
  CHECK_THROWS_AS(paper::companion::table_of_samples(fs::path(folder / "x").parent_path()), std::runtime_error);
  write("loose-eligible-w0.007/seed3", 7);
  const auto text = paper::companion::table_of_samples(fs::path(folder / "x").parent_path());
  CHECK(text.find("| companion paper |  | 6.1 | 2.97 | 3.13 |") != std::string::npos);
  CHECK(text.find("| loose-eligible-w0.007 | 0.600 ± 0.000 | 6.00 ± 0.58 | 2.00 ± 0.00 |") != std::string::npos);
  CHECK(text.find("dense-touching") == std::string::npos);  // one seed
}

TEST_CASE("a claim has three seeds") {
  const scratch::folder folder;
  for (const char* name : {"a/seed1", "a/seed10", "a/seed9", "b/seed1", "b/seed2"})
    write_job(folder / name, "seed 1", 1, 1);
  const auto three = paper::three_runs_of(folder / "a");
  REQUIRE(three.size() == 3);
  CHECK(three[1].folder().filename() == "seed9");
  CHECK_THROWS_AS(paper::three_runs_of(folder / "b"), std::runtime_error);
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
    write_job(shear / "reference/reference" / name, "mass-scaling 1 grains 1000 " + options("4e-6"), 100 + 10 * seed,
              2);
    write_job(compression / "reference/reference" / name, options("4e-6"), 1, 1);
    write_job(shear / "time_step/1e-6" / name, options("9.9999999999999995e-07"), 90 + 11 * seed, 2);
    write_job(shear / "time_step/7e-6" / name, options("7e-6"), 120, 1.75);
  }
  write_job(shear / "skin/0.05/seed1", options_of("4e-6", 1), 110, 3);
  write_job(shear / "grains/2000/seed1", "grains 2000 " + options_of("4e-6", 1), 200, 3);
  write_job(shear / "viscosity/1/seed2", options_of("4e-6", 2), 90, 3);
  write_job(shear / "mass_scaling/4/seed2", "mass-scaling 4 " + options_of("8e-6", 2), 150, 3);
  for (const int seed : {1, 2}) {  // packings of their own
    const auto name = "seed" + std::to_string(seed), options = options_of("4e-6", seed);
    write_job(shear / "stiffness/2000" / name, options, 97 + 2 * seed, 1);
    write_job(shear / "stiffness/1000" / name, options, 80 + 20 * seed, 1);
  }
  const auto studies = paper::convergence::read(fs::path(shear).parent_path(), "shear");
  const auto points_of = [&](const char* name) {
    return std::find_if(studies.begin(), studies.end(), [&](const auto& s) { return s.name == name; })->points;
  };
  CHECK(studies.size() == 8);  // none of the wall's speed
  CHECK((points_of("skin")[0].value == "0.05" && points_of("skin")[0].time == 1.5));
  CHECK(points_of("stiffness")[1].change.mean == within(1e-12, 0.1));
  CHECK(points_of("stiffness")[1].change.error == within(1e-12, std::sqrt(101.0) / 100));
  // mass as it is at the finest step of all; one packing has another mass: the reference's run on it; all of its runs where
  // there are other packings anyway
  CHECK((points_of("mass_scaling")[0].value == "1 at 1e-6 s" && points_of("mass_scaling")[0].stress.mean == 106.5));
  CHECK((points_of("mass_scaling")[1].seeds == 1 && points_of("mass_scaling")[1].stress.mean == 120));
  CHECK(points_of("mass_scaling")[2].change.mean == within(1e-12, 38.0 / 106.5));
  // with Eq. 12 against the reference on the same packing
  CHECK((points_of("viscosity")[0].value == "`coulomb_spring`" && points_of("viscosity")[0].stress.mean == 120));
  CHECK(points_of("viscosity")[1].change.mean == within(1e-12, -0.25));
  CHECK((points_of("grains")[1].seeds == 2 && points_of("grains")[1].change.mean == within(1e-12, 115.0 / 200 - 1)));
  CHECK(points_of("shear_speed").empty());
  const auto points = points_of("time_step");
  REQUIRE(points.size() == 3);
  CHECK(points[0].stress.mean == 106.5);
  CHECK((points[0].change.mean == 0 && points[0].time == 4));
  // differences 110 - 101 and 120 - 112
  CHECK(points[1].change.mean == within(1e-12, 8.5 / 106.5));
  CHECK(points[1].change.error == within(1e-12, 0.5 / 106.5));
  CHECK(points[2].time == 0.5);
  CHECK(points[2].worst_book == 1e-4);
  const auto text = paper::convergence::table_of(studies, "shear");
  CHECK(text.find("| 1e-06 | 106.5 ± 5.5 | 2 | finest | 4.00 | 1e-04 |") != std::string::npos);
  CHECK(text.find("| speed (m/s) | not run yet |") != std::string::npos);
  CHECK_THROWS_AS(paper::convergence::read_rates(fs::path(shear).parent_path()), std::runtime_error);
}

TEST_CASE("capillary laws are compared on the packings that all of them had") {
  const scratch::folder folder;
  const auto shear = folder / "shear", compression = folder / "compression";
  const auto options = [](int seed) { return options_of("4e-6", seed); };
  for (const std::string law : {"law/richefeu-harmonic", "law/willett", "law/laplace-young"}) {
    for (const int seed : {1, 2}) {
      write_job(compression / law / ("seed" + std::to_string(seed)), options(seed), 90 + 10 * seed, 3);
      write_job(shear / law / ("seed" + std::to_string(seed)), options(seed), 270 + 10 * seed, 1);
    }
  }
  for (const int seed : {1, 2, 3}) {
    const auto name = "reference/reference/seed" + std::to_string(seed);
    write_job(compression / name, options(seed), 120 + 10 * seed, 2);
    write_job(shear / name, options(seed), 290 + 100 * seed * (seed - 1), 1);
  }
  for (const int seed : {1, 2}) write_job(shear / ("dry/dry/seed" + std::to_string(seed)), options(seed), 200, 1);
  const auto text = paper::convergence::table_of_laws(fs::path(shear).parent_path());
  // compressed 130, 140, 150 Pa, 30 Pa more than 100 and 110 where there are both; sheared 90 and 290 Pa more than dry
  CHECK(text.find("| `richefeu` | 3 | 140 ± 6 | +28.6 ± 0.0 | 2 | 190 ± 100 | 1.00 |") != std::string::npos);
  CHECK(text.find("| `willett` | 2 | 105 ± 5 | +0.0 ± 0.0 | 2 | 85 ± 5 | 1.50 |") != std::string::npos);
}
