// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../catch.hpp"

#include <pendular/space/graded_grid.hpp>
#include <pendular/space/pair_list.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Grains to be listed, and the search through all pairs that a list is held against.
namespace clouds {

using namespace pendular;

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

  /// Puts the rows into the order of the grid; the answer is where every row was.
  std::vector<std::size_t> sort(const graded_grid& grid) {
    const auto order = grid.order(id);
    permute(order);
    return order;
  }

  /// Row k becomes what was row order[k].
  void permute(const std::vector<std::size_t>& order) {
    const cloud before = *this;
    for (std::size_t k = 0; k < order.size(); ++k) {
      position[k] = before.position[order[k]];
      radius[k] = before.radius[order[k]];
      id[k] = before.id[order[k]];
    }
  }

  std::vector<std::int32_t> list_into(pair_list& list, double range) {
    const graded_grid grid(position, radius, range);
    const auto order = sort(grid);
    return list.rebuild(position, radius, id, grid, range, 0.5 * range, order);
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

inline id_pair ids_of(const pair_list& list, const cloud& c, std::size_t p) {
  return {c.id[static_cast<std::size_t>(list.first()[p])], c.id[static_cast<std::size_t>(list.second()[p])]};
}

/// Pairs of the list by ids; fails if one is listed twice or its first grain is not the one of lower id.
inline std::set<id_pair> listed(const pair_list& list, const cloud& c) {
  std::set<id_pair> found;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const id_pair ids = ids_of(list, c, p);
    REQUIRE(ids.first < ids.second);
    REQUIRE(found.insert(ids).second);
  }
  return found;
}

/// Radii from 0.2 to 1.
inline cloud random_cloud(std::size_t count, double size, std::uint64_t seed, double flatness = 1) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  cloud c;
  for (std::size_t k = 0; k < count; ++k) {
    const double radius = 0.2 + 0.8 * unit(random);  // first: arguments have no order
    c.add({size * (unit(random) - 0.5), size * unit(random) + 3, flatness * size * unit(random)}, radius);
  }
  return c;
}

struct origins {
  std::size_t kept = 0, fresh = 0;
};

/// Makes a list anew and holds what it says of the old one against the ids.
inline origins check_origins(cloud& c, pair_list& list, double range) {
  std::map<id_pair, std::int32_t> before;
  for (std::size_t p = 0; p < list.size(); ++p) before[ids_of(list, c, p)] = static_cast<std::int32_t>(p);
  const auto origin = c.list_into(list, range);
  REQUIRE(origin.size() == list.size());
  origins found;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const auto old = before.find(ids_of(list, c, p));
    REQUIRE(origin[p] == (old == before.end() ? -1 : old->second));
    ++(old == before.end() ? found.fresh : found.kept);
  }
  return found;
}

/// All pairs, each once, and whole blocks.
inline void check(cloud c, double range) {
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

}  // namespace clouds
