// SPDX-License-Identifier: BSD-3-Clause
// The neighbour list against the search through all pairs.
#include "cloud.hpp"

using namespace pendular;
using namespace clouds;

TEST_CASE("pairs of one kind stand together: touching, within reach of a bridge, beyond it") {
  cloud c = random_cloud(100, 6, 5);  // few enough for one chunk
  pair_list list;
  c.list_into(list, 0.2);
  int last = 0;
  std::set<int> met;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const auto i = static_cast<std::size_t>(list.first()[p]), j = static_cast<std::size_t>(list.second()[p]);
    const double gap = norm(c.position[i] - c.position[j]) - c.radius[i] - c.radius[j];
    const int kind = gap <= 0 ? 0 : gap <= 0.1 ? 1 : 2;
    CHECK(kind >= last);
    last = kind;
    met.insert(kind);
  }
  CHECK(met.size() == 3);
}

TEST_CASE("random clouds of any density have the pairs of the full search") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    check(random_cloud(600, 30, seed), 0.3);     // dilute
    check(random_cloud(600, 10, seed), 0.1);     // dense
    check(random_cloud(300, 1, seed), 0.1);      // all in few cells
    check(random_cloud(300, 40, seed), 4);       // a range longer than a radius
    check(random_cloud(300, 30, seed, 0), 0.3);  // flat
  }
  CHECK(random_cloud(600, 10, 1).all_pairs(0.1).size() > 1000);
}

TEST_CASE("one grain, two grains and grains in one point are listed too") {
  for (const std::size_t count : {1u, 2u, 3u}) check(random_cloud(count, 2, 4), 0.5);
  cloud heap;
  for (int k = 0; k < 20; ++k) heap.add({1, 1, 1}, 1);
  check(heap, 0.1);
  CHECK(heap.all_pairs(0.1).size() == 190);
}

TEST_CASE("grains on the borders of cells are not lost") {
  // A lattice whose spacing is the edge of a cell, and one of half of it.
  for (const double spacing : {1.0, 2.0, 2.5, 1.25}) {
    cloud lattice;
    for (int a = 0; a < 6; ++a) {
      for (int b = 0; b < 6; ++b) {
        for (int c = 0; c < 6; ++c) lattice.add({spacing * a, spacing * b, spacing * c}, 1);
      }
    }
    check(lattice, 0.5);
  }
}

TEST_CASE("a grain far away costs no pairs") {
  cloud c = random_cloud(400, 10, 5);
  c.add({1e7, -1e7, 1e7}, 1);
  check(c, 0.2);
  c.add({1e7 + 1.5, -1e7, 1e7}, 1);
  check(c, 0.2);
}

TEST_CASE("every pair knows which pair of the old list it was, although grains moved and rows were reordered") {
  cloud c = random_cloud(500, 10, 6);
  pair_list list;
  for (const std::int32_t o : c.list_into(list, 0.3)) CHECK(o == -1);
  boost::random::mt19937_64 random(7);
  boost::random::uniform_real_distribution<double> shift(-0.3, 0.3);
  for (int round = 0; round < 3; ++round) {
    for (vector& p : c.position) p += vector{shift(random), shift(random), shift(random)};
    const auto [kept, fresh] = check_origins(c, list, 0.3);
    CHECK((kept > 100 && fresh > 100));
  }
}

TEST_CASE("grains that were added to a list of before have no origin") {
  cloud c = random_cloud(50, 4, 8);
  pair_list list;
  c.list_into(list, 0.3);
  const std::size_t old_size = list.size();
  for (const vector& p : {vector{0, 4, 1}, vector{0.5, 5, 2}}) c.add(p, 1);
  const auto origin = c.list_into(list, 0.3);
  std::set<std::int32_t> seen;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const bool has_new = c.id[static_cast<std::size_t>(list.second()[p])] >= 50;
    CHECK((origin[p] < 0) == has_new);
    if (!has_new) seen.insert(origin[p]);
  }
  CHECK(seen.size() == old_size);
}

TEST_CASE("the pairs of a grain are sorted by the partner's id and signed by its side") {
  cloud c = random_cloud(300, 8, 9);
  pair_list list;
  c.list_into(list, 0.3);
  std::size_t incidences = 0;
  for (std::size_t row = 0; row < c.id.size(); ++row) {
    std::int64_t last = -1;
    for (const auto& n : list.pairs_of(row)) {
      const auto p = static_cast<std::size_t>(n.pair);
      const auto own = n.is_second ? list.second()[p] : list.first()[p];
      const auto partner = n.is_second ? list.first()[p] : list.second()[p];
      REQUIRE(static_cast<std::size_t>(own) == row);
      CHECK(c.id[static_cast<std::size_t>(partner)] > last);
      last = c.id[static_cast<std::size_t>(partner)];
      ++incidences;
    }
  }
  CHECK(incidences == 2 * list.size());
}

TEST_CASE("the list does not depend on the order in which the rows were stored") {
  cloud one = random_cloud(200, 8, 10), other = one;
  std::reverse(other.position.begin(), other.position.end());
  std::reverse(other.radius.begin(), other.radius.end());
  std::reverse(other.id.begin(), other.id.end());
  pair_list of_one, of_other;
  one.list_into(of_one, 0.3);
  other.list_into(of_other, 0.3);
  REQUIRE(of_one.size() == of_other.size());
  CHECK(one.id == other.id);
  CHECK(std::equal(of_one.first().begin(), of_one.first().end(), of_other.first().begin()));
  CHECK(std::equal(of_one.second().begin(), of_one.second().end(), of_other.second().begin()));
}

TEST_CASE("an empty list has no pairs and no padding") {
  cloud c;
  c.add({0, 0, 0}, 1);
  c.add({10, 0, 0}, 1);
  pair_list list;
  CHECK(c.list_into(list, 0.5).empty());
  CHECK((list.size() == 0 && list.padded_size() == 0 && list.pairs_of(0).empty()));
}
