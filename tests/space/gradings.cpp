// SPDX-License-Identifier: BSD-3-Clause
// Grids and lists of grains of very different sizes, against the search through all pairs.
#include "cloud.hpp"

#include <boost/random/uniform_int_distribution.hpp>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <functional>
#include <numeric>

using namespace pendular;
using namespace clouds;

namespace {
/// Radii of numbers from 0 to 1.
using radius_of = std::function<double(double)>;

double equal(double) { return 1; }
double twofold(double share) { return 1 + share; }
double fourfold(double share) { return 1 + 3 * share; }
double logarithmic(double share) { return std::pow(30.0, share); }
double either(double share) { return share < 0.9 ? 1 : 9; }
double powers(double share) { return std::pow(3.0, std::floor(20 * share)); }

/// Spread over a cube, as dense as a packing if none were large.
cloud graded(std::size_t count, const radius_of& of_share, std::uint64_t seed, double size) {
  cloud c = random_cloud(count, size, seed);
  for (double& r : c.radius) r = of_share((r - 0.2) / 0.8);
  return c;
}

/// In heaps of one size of grain each, which lie apart but for their rims.
cloud segregated(std::size_t count, std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(-1, 1);
  cloud c;
  for (std::size_t k = 0; k < count; ++k) {
    const double r = std::array<double, 4>{1, 2.5, 7, 20}[k % 4];
    c.add({4 * r * unit(random) + 5 * r, 4 * r * unit(random), 4 * r * unit(random)}, r);
  }
  return c;
}

/// A large grain in the middle of small ones of one radius.
cloud with_one_large(std::size_t small, double ratio, std::uint64_t seed) {
  cloud c;
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t k = 0; k < small; ++k) {
    if (k == small / 3) c.add({0, 0, 0}, ratio);
    const vector direction{unit(random), unit(random), unit(random)};
    c.add(((ratio + 3 + 2 * unit(random)) / norm(direction)) * direction, 1);
  }
  return c;
}

void shuffle(cloud& c, std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  std::vector<std::size_t> order(c.id.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = order.size(); k > 1; --k) {
    std::swap(order[k - 1], order[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(random)]);
  }
  c.permute(order);
}

bool same_list(const pair_list& a, const pair_list& b) {
  return a.size() == b.size() && std::equal(a.first().begin(), a.first().end(), b.first().begin(), b.first().end()) &&
         std::equal(a.second().begin(), a.second().end(), b.second().begin(), b.second().end());
}

std::size_t classes(const cloud& c, double range) { return size_classes(c.radius, range).all().size(); }

struct fingerprint {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a

  void add(std::int64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      hash ^= static_cast<std::uint64_t>(value >> (8 * byte)) & 0xff;
      hash *= 1099511628211u;
    }
  }
};
}  // namespace

TEST_CASE("lists of any grading have the pairs of the full search") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    for (const auto& grading : {equal, twofold, fourfold, logarithmic, either, powers}) {
      check(graded(500, grading, seed, 14), 0.3);
      check(graded(500, grading, seed, 60), 0.05);
      check(graded(300, grading, seed, 200), 25);  // far longer than the small ones
    }
    check(segregated(600, seed), 0.3);
    for (const double ratio : {1.5, 4.0, 30.0, 1000.0}) check(with_one_large(400, ratio, seed), 0.3);
  }
  CHECK(with_one_large(400, 30, 1).all_pairs(0.3).size() > 50);
  CHECK(segregated(600, 1).all_pairs(0.3).size() > 1000);
}

TEST_CASE("large grains among small ones are in a class of their own and leave the small ones in one") {
  CHECK(classes(graded(500, equal, 1, 20), 0.3) == 1);
  CHECK(classes(graded(500, twofold, 1, 20), 0.3) == 1);
  CHECK(classes(graded(500, powers, 1, 20), 0.3) > 5);
  cloud c = graded(500, twofold, 1, 20);
  c.add({0, 0, 0}, 30);
  c.add({50, 0, 0}, 31);
  const size_classes two(c.radius, 0.3);
  REQUIRE(two.all().size() == 2);
  CHECK((two.all()[0].rows == std::vector<std::size_t>{500, 501} && two.all()[1].rows.size() == 500));
  CHECK(two.all()[0].halo == within(1e-15, 31.15));
}

TEST_CASE("every grain is in one class, none is wider than a factor of four in radius and half of the range") {
  for (const auto& grading : {equal, twofold, fourfold, logarithmic, either, powers}) {
    const cloud c = graded(2000, grading, 4, 50);
    std::set<std::size_t> met;
    double above = 1e300;
    const size_classes classes_of_all(c.radius, 0.4);
    for (const auto& k : classes_of_all.all()) {
      double least = 1e300, most = 0;
      for (const std::size_t row : k.rows) {
        CHECK(met.insert(row).second);
        least = std::min(least, c.radius[row] + 0.2), most = std::max(most, c.radius[row] + 0.2);
      }
      CHECK((most <= 4 * least && most < above));
      above = least;
    }
    CHECK(met.size() == 2000);
  }
}

TEST_CASE("grains of one class have the order and the list that a single grid gave") {
  // Sizes of the list and hashes of ids, pairs, origins and incidences of two lists one after the other, from the code at
  // commit d9accb7, which had one grid with cells of the largest diameter and the range.
  struct known {
    std::size_t grains;
    double size, flatness, range;
    std::size_t pairs;
    std::uint64_t hash;
  };
  for (const known& k :
       {known{2000, 16, 1, 0.2, 9422, 13813314831974511808u}, known{500, 200, 1, 0.2, 1, 8648983796098949905u},
        known{1500, 60, 0, 0.3, 3059, 12779030025082538694u}, known{3000, 12, 1, 1.5, 220429, 7128834506775381367u}}) {
    cloud c = random_cloud(k.grains, k.size, 11, k.flatness);
    for (double& r : c.radius) r = 0.375 + 0.625 * r;
    pair_list list;
    fingerprint f;
    for (int round = 0; round < 2; ++round) {
      const auto origin = c.list_into(list, k.range);
      for (const auto id : c.id) f.add(id);
      for (const auto row : list.first()) f.add(row);
      for (const auto row : list.second()) f.add(row);
      for (const auto pair : origin) f.add(pair);
      for (std::size_t row = 0; row < c.id.size(); ++row) {
        for (const auto& n : list.pairs_of(row)) f.add(2 * static_cast<std::int64_t>(n.pair) + n.is_second);
      }
      for (std::size_t g = 0; g < c.id.size(); ++g) {
        c.position[g] += 0.3 * vector{c.radius[g] - 0.7, 0.75 - c.radius[g], c.radius[g] - 0.6};
      }
    }
    CHECK(list.size() == k.pairs);
    CHECK(f.hash == k.hash);
  }
}

TEST_CASE("one large grain changes neither the order of the small ones nor the pairs among them") {
  cloud small = graded(800, twofold, 5, 20), all = small;
  all.add({3, 12, 5}, 40);
  pair_list of_small, of_all;
  small.list_into(of_small, 0.3);
  all.list_into(of_all, 0.3);
  REQUIRE(all.id.front() == 800);  // largest first
  CHECK(std::equal(small.id.begin(), small.id.end(), all.id.begin() + 1, all.id.end()));
  const auto among = listed(of_small, small);
  std::set<id_pair> with_large = listed(of_all, all);
  std::erase_if(with_large, [](const id_pair& p) { return p.second == 800; });
  CHECK((among == with_large));
}

TEST_CASE("list, order and origins of any grading do not depend on the order before") {
  for (const auto& grading : {logarithmic, either, powers}) {
    cloud one = graded(600, grading, 6, 30), other = one;
    shuffle(other, 7);
    pair_list of_one, of_other;
    for (int round = 0; round < 2; ++round) {
      const auto origin_one = one.list_into(of_one, 0.3), origin_other = other.list_into(of_other, 0.3);
      CHECK(one.id == other.id);
      CHECK(same_list(of_one, of_other));
      CHECK(origin_one == origin_other);
      for (cloud* c : {&one, &other}) {
        for (vector& p : c->position) p = 1.05 * p;
      }
    }
    CHECK(classes(one, 0.3) > 1);
    CHECK(of_one.size() > 300);
  }
}

#ifdef _OPENMP
TEST_CASE("list and origins of any grading do not depend on the number of threads") {
  const int before = omp_get_max_threads();
  for (const auto& grading : {equal, logarithmic, either}) {
    std::vector<pair_list> lists(3);
    std::vector<std::vector<std::int32_t>> origins;
    std::vector<std::vector<std::uint32_t>> incidences(3);
    for (const int count : {1, 2, 5}) {
      omp_set_num_threads(count);
      cloud c = graded(1500, grading, 8, 30);
      c.add({0, 15, 15}, 12);
      pair_list& list = lists[origins.size()];
      c.list_into(list, 0.3);
      for (vector& p : c.position) p = 1.02 * p;
      auto& seen = incidences[origins.size()];
      origins.push_back(c.list_into(list, 0.3));
      for (std::size_t row = 0; row < c.id.size(); ++row) {
        for (const auto& n : list.pairs_of(row)) seen.push_back(2 * n.pair + n.is_second);
      }
    }
    omp_set_num_threads(before);
    for (const std::size_t k : {1u, 2u}) {
      CHECK(same_list(lists[0], lists[k]));
      CHECK(origins[0] == origins[k]);
      CHECK(incidences[0] == incidences[k]);
    }
    CHECK(lists[0].size() > 1000);
  }
}
#endif

TEST_CASE("pairs of a large grain are followed into the next list, whether its id is low, high or between") {
  for (const std::uint64_t seed : {1u, 2u}) {
    for (const std::int64_t id : {-1, 500, 5000}) {
      cloud c = with_one_large(1500, 30, seed);
      c.id[500] = id;  // of the large grain
      pair_list list;
      c.list_into(list, 0.5);
      boost::random::mt19937_64 random(seed + 9);
      boost::random::uniform_real_distribution<double> shift(-0.4, 0.4);
      for (int round = 0; round < 3; ++round) {
        for (vector& p : c.position) p += vector{shift(random), shift(random), shift(random)};
        const auto [kept, fresh] = check_origins(c, list, 0.5);
        CHECK((kept > 300 && fresh > 100));
      }
      CHECK(list.pairs_of(0).size() > 100);
    }
  }
}

TEST_CASE("a grain far away costs no memory and loses no pair, be it large or small") {
  for (const double far : {1e3, 1e9, 1e60}) {
    for (const double radius : {1.0, 30.0}) {
      cloud c = graded(300, twofold, 9, 12);
      c.add({far, -far, far}, radius);
      check(c, 0.3);
      c.add({-far, far, far}, 20 * radius);
      check(c, 0.3);
      std::size_t cells = 0;
      const size_classes classes_of_all(c.radius, 0.3);
      for (const auto& k : classes_of_all.all()) {
        std::vector<vector> points;
        for (const std::size_t row : k.rows) points.push_back(c.position[row]);
        cells += cell_grid(points, 2 * k.halo).cell_count();
      }
      CHECK(cells <= 4 * c.id.size() + 3 * 64);
    }
  }
}

TEST_CASE("what is looked at grows with the grains, not with the size of the largest") {
  const auto looked_at = [](cloud c) {
    const graded_grid grid(c.position, c.radius, 0.3);
    c.sort(grid);
    std::size_t tests = 0;
    for (std::size_t row = 0; row < c.id.size(); ++row) {
      grid.for_candidates(row, c.position[row], c.radius[row],
                          [&](std::size_t from, std::size_t to) { tests += 1 + (from < to ? to - from : 0); });
    }
    return static_cast<double>(tests);
  };
  const cloud small = graded(4000, equal, 10, 30);
  const double without = looked_at(small);
  for (const double ratio : {3.0, 10.0, 30.0, 1e3, 1e6}) {
    cloud c = small;
    c.add({0, 18, 31 + ratio}, ratio);
    CHECK(looked_at(c) < 1.2 * without);
  }
  cloud large = graded(400, equal, 11, 14);
  const double of_large = looked_at(large);
  for (int k = 0; k < 20; ++k) large.add({-7 + 0.7 * k, 3 + 0.7 * k, 0.7 * k}, 0.03);
  CHECK(looked_at(large) < 1.2 * of_large);
  CHECK(looked_at(graded(4000, fourfold, 10, 90)) < 2 * without);
  CHECK(looked_at(graded(4000, logarithmic, 10, 420)) < 2 * without);
}

TEST_CASE("no grains have an order and a list without entries, before and after there were some") {
  cloud none, some = graded(50, equal, 1, 4);
  pair_list list;
  for (int round = 0; round < 2; ++round) {
    CHECK(none.list_into(list, 0.3).empty());
    CHECK((list.size() == 0 && list.padded_size() == 0 && list.range() == 0.3));
    CHECK(graded_grid(none.position, none.radius, 0.3).order(none.id).empty());
    some.list_into(list, 0.3);
    CHECK((listed(list, some) == some.all_pairs(0.3)));
  }
}
