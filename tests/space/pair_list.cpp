// SPDX-License-Identifier: BSD-3-Clause
// The neighbour list against the search through all pairs.
#include "../catch.hpp"

#include <pendular/space/cell_grid.hpp>
#include <pendular/space/pair_list.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

using namespace pendular;

namespace {
using id_pair = std::pair<std::int64_t, std::int64_t>;

struct cloud {
  std::vector<vector> position;
  std::vector<double> radius;
  std::vector<std::int64_t> id;

  void add(const vector& p, double r) {
    id.push_back(static_cast<std::int64_t>(id.size()));
    position.push_back(p);
    radius.push_back(r);
  }

  double edge(double range) const { return 2 * *std::max_element(radius.begin(), radius.end()) + range; }

  /// Puts the rows into the order of the grid; the answer is where every row was.
  std::vector<std::size_t> sort(double range) {
    const auto order = cell_grid(position, edge(range)).order(id);
    const cloud before = *this;
    for (std::size_t k = 0; k < order.size(); ++k) {
      position[k] = before.position[order[k]];
      radius[k] = before.radius[order[k]];
      id[k] = before.id[order[k]];
    }
    return order;
  }

  std::vector<std::int32_t> list_into(pair_list& list, double range) {
    const auto order = sort(range);
    return list.rebuild(position, radius, id, cell_grid(position, edge(range)), range, 0.5 * range, order);
  }

  std::set<id_pair> all_pairs(double range) const {
    std::set<id_pair> found;
    for (std::size_t a = 0; a < id.size(); ++a) {
      for (std::size_t b = a + 1; b < id.size(); ++b) {
        const double distance =
            std::hypot(position[a].x - position[b].x, position[a].y - position[b].y, position[a].z - position[b].z);
        if (distance - radius[a] - radius[b] <= range) found.insert(std::minmax(id[a], id[b]));
      }
    }
    return found;
  }
};

/// Pairs of the list by ids; fails if one is listed twice or its first grain is not the one of lower id.
std::set<id_pair> listed(const pair_list& list, const cloud& c) {
  std::set<id_pair> found;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const auto i = c.id[static_cast<std::size_t>(list.first()[p])],
               j = c.id[static_cast<std::size_t>(list.second()[p])];
    REQUIRE(i < j);
    REQUIRE(found.insert({i, j}).second);
  }
  return found;
}

cloud random_cloud(std::size_t count, double size, std::uint64_t seed, double flatness = 1) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  cloud c;
  for (std::size_t k = 0; k < count; ++k) {
    c.add({size * (unit(random) - 0.5), size * unit(random) + 3, flatness * size * unit(random)},
          0.2 + 0.8 * unit(random));
  }
  return c;
}

void check(cloud c, double range) {
  pair_list list;
  c.list_into(list, range);
  const auto expected = c.all_pairs(range);
  REQUIRE((listed(list, c) == expected));
  CHECK(list.range() == range);
  CHECK(list.padded_size() == padded(list.size()));
  for (std::size_t p = list.size(); p < list.padded_size(); ++p) {
    CHECK((list.first()[p] == list.first()[list.size() - 1] && list.second()[p] == list.second()[list.size() - 1]));
  }
}
}  // namespace

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

TEST_CASE("a grain far away costs no pairs and no memory") {
  cloud c = random_cloud(400, 10, 5);
  c.add({1e7, -1e7, 1e7}, 1);
  check(c, 0.2);
  c.add({1e7 + 1.5, -1e7, 1e7}, 1);
  check(c, 0.2);
  CHECK(cell_grid(c.position, c.edge(0.2)).starts().size() <= 4 * c.id.size() + 65);
}

TEST_CASE("every pair knows which pair of the old list it was, although grains moved and rows were reordered") {
  cloud c = random_cloud(500, 10, 6);
  pair_list list;
  for (const std::int32_t o : c.list_into(list, 0.3)) CHECK(o == -1);
  boost::random::mt19937_64 random(7);
  boost::random::uniform_real_distribution<double> shift(-0.3, 0.3);
  for (int round = 0; round < 3; ++round) {
    std::map<id_pair, std::int32_t> before;
    for (std::size_t p = 0; p < list.size(); ++p) {
      before[{c.id[static_cast<std::size_t>(list.first()[p])], c.id[static_cast<std::size_t>(list.second()[p])]}] =
          static_cast<std::int32_t>(p);
    }
    for (vector& p : c.position) p += vector{shift(random), shift(random), shift(random)};
    const auto origin = c.list_into(list, 0.3);
    REQUIRE(origin.size() == list.size());
    std::size_t kept = 0, fresh = 0;
    for (std::size_t p = 0; p < list.size(); ++p) {
      const auto old = before.find(
          {c.id[static_cast<std::size_t>(list.first()[p])], c.id[static_cast<std::size_t>(list.second()[p])]});
      REQUIRE(origin[p] == (old == before.end() ? -1 : old->second));
      ++(old == before.end() ? fresh : kept);
    }
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
