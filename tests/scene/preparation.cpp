// SPDX-License-Identifier: BSD-3-Clause
// Gradings, placement and measures of a sample, against numbers of the paper and sums done by hand.
#include "../catch.hpp"

#include <pendular/scene/grading.hpp>
#include <pendular/scene/placement.hpp>
#include <pendular/scene/sample.hpp>

#include <cmath>
#include <map>
#include <numbers>

using namespace pendular;
using namespace pendular::scene;

namespace {
std::map<double, int> counted(const std::vector<double>& diameters_of_grains) {
  std::map<double, int> counts;
  for (const double d : diameters_of_grains) ++counts[d];
  return counts;
}
}  // namespace

TEST_CASE("eight thousand grains of the compression sample have the proportions of the table, to the grain") {
  const auto counts = counted(diameters(compression_grading(), 8000, 1));
  CHECK(counts == std::map<double, int>{
                      {0.8e-3, 800}, {0.9e-3, 1600}, {1.0e-3, 1600}, {1.1e-3, 1600}, {1.2e-3, 1600}, {1.3e-3, 800}});
}

TEST_CASE("their mean diameter is 1.05 mm and their solid volume 5146 mm3") {
  CHECK(mean_diameter(compression_grading()) == within(1e-14, 1.05e-3));
  double volume = 0;
  for (const double d : diameters(compression_grading(), 8000, 1)) volume += std::numbers::pi / 6 * d * d * d;
  CHECK(volume == near(0.5e-9, 5146e-9));
}

TEST_CASE("numbers that do not divide add up all the same") {
  for (const std::int64_t count : {1, 2, 3, 7, 61, 7307}) {
    CHECK(diameters(compression_grading(), count, 3).size() == static_cast<std::size_t>(count));
  }
  const auto counts = counted(diameters({{1e-3, 1.0 / 3}, {2e-3, 1.0 / 3}, {3e-3, 1.0 / 3}}, 10, 1));
  for (const auto& [d, n] : counts) CHECK((n == 3 || n == 4));
}

TEST_CASE("the order of the diameters is mixed, fixed by the seed") {
  const auto one = diameters(compression_grading(), 8000, 1);
  CHECK(one == diameters(compression_grading(), 8000, 1));
  CHECK(one != diameters(compression_grading(), 8000, 2));
  // 800 of 8000 are the smallest: about 100 among the first thousand (4 standard deviations).
  int small = 0;
  for (std::size_t k = 0; k < 1000; ++k) small += one[k] == 0.8e-3 ? 1 : 0;
  CHECK(std::abs(small - 100) < 4 * std::sqrt(1000 * 0.1 * 0.9));
}

TEST_CASE("gradings without meaning are refused") {
  CHECK_THROWS_AS(diameters(compression_grading(), 0, 1), input_error);
  CHECK_THROWS_AS(diameters({}, 10, 1), input_error);
  CHECK_THROWS_AS(diameters({{1e-3, 0.5}, {2e-3, 0.3}}, 10, 1), input_error);
  CHECK_THROWS_AS(diameters({{1e-3, 0.5}, {2e-3, 0.7}}, 10, 1), input_error);
}

TEST_CASE("a loose column has all grains inside the cylinder, above the floor and apart") {
  const auto sizes = diameters(compression_grading(), 2000, 5);
  const double radius = 6e-3;
  const auto column_of_grains = loose_column(sizes, 2700, radius, 0.1, 5);
  REQUIRE(column_of_grains.size() == sizes.size());
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const grain& g = column_of_grains[a];
    CHECK(2 * g.radius == sizes[a]);
    CHECK(g.density == 2700);
    CHECK(std::hypot(g.position.x, g.position.y) + g.radius < radius);
    CHECK(g.position.z > g.radius);
    CHECK(g.velocity.z == -0.1);
    CHECK((std::abs(g.velocity.x) <= 0.01 && std::abs(g.velocity.y) <= 0.01));
    double nearest = 1;
    for (std::size_t b = 0; b < a; ++b) {
      const grain& other = column_of_grains[b];
      nearest = std::min(nearest, norm(g.position - other.position) - g.radius - other.radius);
    }
    CHECK(nearest > 0);
  }
}

TEST_CASE("a loose column is the same for the same seed and another for another") {
  const std::vector<double> sizes(50, 1e-3);
  const auto one = loose_column(sizes, 2700, 4e-3, 0.1, 1), again = loose_column(sizes, 2700, 4e-3, 0.1, 1);
  const auto other = loose_column(sizes, 2700, 4e-3, 0.1, 2);
  bool same = true, different = false;
  for (std::size_t k = 0; k < 50; ++k) {
    same &= one[k].position == again[k].position && one[k].velocity == again[k].velocity;
    different |= !(one[k].position == other[k].position);
  }
  CHECK((same && different));
}

TEST_CASE("the narrowest cylinder that is accepted holds grains, a narrower one is refused") {
  CHECK(loose_column(std::vector<double>(20, 1e-3), 2700, 1.6e-3, 0.1, 1).size() == 20);
  CHECK_THROWS_AS(loose_column(std::vector<double>(20, 1e-3), 2700, 1.5e-3, 0.1, 1), input_error);
}

TEST_CASE("a sample is measured by volume, tops and centre of mass") {
  grains<false, false> g;
  g.add({{0, 0, 1}, 1, 2});
  g.add({{5, 0, 7}, 2, 1});  // four times as heavy
  g.add({{0, 5, 3}, 1, 2});
  CHECK(solid_volume(g) == within(1e-14, 40 * std::numbers::pi / 3));
  CHECK(tops(g) == std::vector<double>{9, 4, 2});
  CHECK(surface_height(g) == 9);
  CHECK(mass_centre_height(g) == within(1e-14, 32.0 / 6));
  const std::vector<std::size_t> order{2, 0, 1};
  g.permute(order);
  CHECK(positions_by_id(g) == std::vector<vector>{{0, 0, 1}, {5, 0, 7}, {0, 5, 3}});
}

TEST_CASE("the surface is the mean over the highest hundredth of the grains") {
  grains<false, false> g;
  for (int k = 0; k < 250; ++k) g.add({{0, 0, 10.0 * k}, 1, 1});
  CHECK(surface_height(g) == within(1e-14, 2486));  // 2491 and 2481
}
