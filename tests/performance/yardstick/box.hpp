// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

// What the scenes written by hand have in common: grains in a box, sorted by cell, lists of what is near what, and how
// centres move. No force.
namespace yardstick {

using pendular::block;
using pendular::quad;
using pendular::quad_block;
using pendular::Vec3;
using pendular::vector;
using lanes3 = Vec3<block>;
using four = double __attribute__((vector_size(32), may_alias));
using rows = std::vector<std::int32_t>;

/// A row as one register; by reference only, because by value the width decides about the calling convention.
inline four& whole(quad& row) { return reinterpret_cast<four&>(row); }
inline const four& whole(const quad& row) { return reinterpret_cast<const four&>(row); }

/// Of all scenes: springs and two-sided dashpots, one clock.
struct parameters {
  double stiffness = 1e3, damping = 0.8, friction = 0.4;
  double time_step = 1e-6, gravity = -9.81, skin = 0.2;
};

/// The six planes: 2 * axis, and 1 more for the upper one.
constexpr std::size_t wall_count = 6;

/// Pairs of rows with a gap below some range, the grain of lower id first, padded to whole blocks.
struct pair_rows {
  rows first, second;
  std::size_t count = 0;
  std::vector<std::size_t> start;       // where the pairs of a grain begin in
  std::vector<std::uint32_t> incident;  // 2 * pair + (1 for the second grain)

  std::size_t size() const { return first.size(); }
};

/// Grains near a plane, padded to whole blocks.
struct wall_rows {
  rows grain;
  std::size_t count = 0;

  std::size_t size() const { return grain.size(); }
};

class box {
 public:
  std::vector<quad> place, motion;  // position and radius, m; velocity, m/s, and inverse mass, 1/kg
  std::vector<std::int64_t> id;
  pair_rows pairs;
  wall_rows walls[wall_count];
  std::vector<std::size_t> came_from;  // the row a grain had in the list before
  int relisted = 0;

  box(const std::vector<pendular::grain>& grains, const vector& size, const parameters& p)
      : edges_{size.x, size.y, size.z}, time_step_(p.time_step), gravity_(p.gravity) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& g : grains) {
      const double mass = 4.0 / 3 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
      place.push_back({g.position.x, g.position.y, g.position.z, g.radius});
      motion.push_back({g.velocity.x, g.velocity.y, g.velocity.z, 1 / mass});
      id.push_back(static_cast<std::int64_t>(id.size()));
      smallest = std::min(smallest, g.radius);
      largest_ = std::max(largest_, g.radius);
    }
    skin_ = p.skin * smallest;
  }

  std::size_t size() const { return place.size(); }
  double largest_radius() const { return largest_; }
  /// The upper plane of an axis, m.
  double edge(std::size_t axis) const { return edges_[axis]; }
  vector centre(std::size_t k) const { return {place[k].a, place[k].b, place[k].c}; }

  /// First half of a step, synchronised velocity Verlet; true if the grain is far from where it was listed. The last of
  /// the four numbers of a force is 0.
  bool predict(std::size_t k, const four& force) {
    const double dt = time_step_;
    const four along{dt, dt, dt, 0}, down{0, 0, gravity_, 0};
    four v = whole(motion[k]);
    const four a = v[3] * force + down, x = whole(place[k]) + (along * v + (0.5 * dt * dt) * a);
    v += dt * a;
    whole(place[k]) = x;
    whole(motion[k]) = v;
    const four d = x - whole(listed_at_[k]), square = d * d;
    return !(square[0] + square[1] + square[2] < 0.25 * skin_ * skin_);
  }

  /// Second half, from the change of the force.
  void correct(std::size_t k, const four& change) {
    const four v = whole(motion[k]);
    whole(motion[k]) = v + (0.5 * time_step_ * v[3]) * change;
  }

  /// Lists what has a gap below skin + reach; within 256 grains touching pairs come first, then those within reach.
  void relist(double reach) {
    ++relisted;
    const double range = skin_ + reach, cell = 2 * largest_ + range;
    sort(cell);
    find_pairs(cell, range, reach);
    find_wall_rows();
    listed_at_ = place;
  }

  /// For every pair which one of the list before it was, or -1.
  rows origin_of_pairs(const pair_rows& before) const {
    rows origin(pairs.count, -1);
    if (before.count == 0) return origin;
    for (std::size_t p = 0; p < pairs.count; ++p) {
      const auto i = static_cast<std::size_t>(pairs.first[p]), j = static_cast<std::size_t>(pairs.second[p]);
      const auto partner = static_cast<std::int32_t>(came_from[j]);
      for (std::size_t m = before.start[came_from[i]]; m < before.start[came_from[i] + 1]; ++m) {
        const std::size_t old = before.incident[m] >> 1;
        if (before.first[old] == partner || before.second[old] == partner) origin[p] = static_cast<std::int32_t>(old);
      }
    }
    return origin;
  }

  /// The same for the grains near a wall.
  rows origin_of_wall_rows(std::size_t wall, const wall_rows& before) const {
    rows old(size(), -1), origin;
    for (std::size_t r = 0; r < before.count; ++r)
      old[static_cast<std::size_t>(before.grain[r])] = static_cast<std::int32_t>(r);
    for (std::size_t r = 0; r < walls[wall].count; ++r)
      origin.push_back(old[came_from[static_cast<std::size_t>(walls[wall].grain[r])]]);
    return origin;
  }

  std::vector<vector> positions_by_id() const {
    std::vector<vector> all(size());
    for (std::size_t k = 0; k < size(); ++k) all[static_cast<std::size_t>(id[k])] = centre(k);
    return all;
  }

  /// To be called for every other column of the grains after a new list.
  template <class T>
  void permute(std::vector<T>& column) const {
    auto moved = column;
    for (std::size_t k = 0; k < size(); ++k) moved[k] = column[came_from[k]];
    column.swap(moved);
  }

 private:
  void sort(double cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<std::int64_t>(edges_[axis] / cell) + 1;
    std::vector<std::size_t> cells(size());
    for (std::size_t k = 0; k < size(); ++k) cells[k] = cell_of(place[k], cell);
    came_from.resize(size());
    std::iota(came_from.begin(), came_from.end(), std::size_t{0});
    std::sort(came_from.begin(), came_from.end(),
              [&](std::size_t a, std::size_t b) { return cells[a] != cells[b] ? cells[a] < cells[b] : id[a] < id[b]; });
    permute(place), permute(motion), permute(id);
    cell_start_.assign(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]) + 1, 0);
    for (const std::size_t c : cells) ++cell_start_[c + 1];
    std::partial_sum(cell_start_.begin(), cell_start_.end(), cell_start_.begin());
  }

  std::int64_t along(double x, std::size_t axis, double cell) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(x / cell), 0, counts_[axis] - 1);
  }
  std::size_t cell_of(const quad& x, double cell) const {
    return static_cast<std::size_t>((along(x.c, 2, cell) * counts_[1] + along(x.b, 1, cell)) * counts_[0] +
                                    along(x.a, 0, cell));
  }

  void find_pairs(double cell, double range, double reach) {
    rows kinds[3];
    pairs.first.clear(), pairs.second.clear();
    for (std::size_t a = 0; a < size(); ++a) {
      find_partners(a, cell, range, reach, kinds);
      if (a % 256 == 255 || a + 1 == size()) empty(kinds);
    }
    pairs.count = pairs.first.size();
    list_incidences();
    if (pairs.count == 0) return;
    pairs.first.resize(pendular::padded(pairs.count), pairs.first.back());
    pairs.second.resize(pendular::padded(pairs.count), pairs.second.back());
  }

  void empty(rows (&kinds)[3]) {
    for (auto& kind : kinds) {
      for (std::size_t k = 0; k < kind.size(); k += 2) {
        pairs.first.push_back(kind[k]);
        pairs.second.push_back(kind[k + 1]);
      }
      kind.clear();
    }
  }

  void find_partners(std::size_t a, double cell, double range, double reach, rows (&kinds)[3]) const {
    const auto low = [](std::int64_t c) { return std::max<std::int64_t>(c - 1, 0); };
    const auto high = [&](std::int64_t c, std::size_t axis) { return std::min(c + 1, counts_[axis] - 1); };
    const auto x = along(place[a].a, 0, cell), y = along(place[a].b, 1, cell), z = along(place[a].c, 2, cell);
    for (std::int64_t k = low(z); k <= high(z, 2); ++k) {
      for (std::int64_t j = low(y); j <= high(y, 1); ++j) {
        const std::int64_t line = (k * counts_[1] + j) * counts_[0];
        const std::size_t from = cell_start_[static_cast<std::size_t>(line + low(x))];
        const std::size_t to = cell_start_[static_cast<std::size_t>(line + high(x, 0)) + 1];
        for (std::size_t b = std::max(from, a + 1); b < to; ++b) add_pair(a, b, range, reach, kinds);
      }
    }
  }

  void add_pair(std::size_t a, std::size_t b, double range, double reach, rows (&kinds)[3]) const {
    const vector d = centre(b) - centre(a);
    const double sum = place[a].d + place[b].d, square = dot(d, d);
    if (square > (sum + range) * (sum + range)) return;
    const bool in_order = id[a] < id[b];
    auto& kind = kinds[square <= sum * sum ? 0 : square <= (sum + reach) * (sum + reach) ? 1 : 2];
    kind.push_back(static_cast<std::int32_t>(in_order ? a : b));
    kind.push_back(static_cast<std::int32_t>(in_order ? b : a));
  }

  void list_incidences() {
    auto& start = pairs.start;
    start.assign(size() + 1, 0);
    for (std::size_t p = 0; p < pairs.count; ++p) {
      ++start[static_cast<std::size_t>(pairs.first[p]) + 1];
      ++start[static_cast<std::size_t>(pairs.second[p]) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    pairs.incident.resize(2 * pairs.count);
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (std::size_t p = 0; p < pairs.count; ++p) {
      pairs.incident[next[static_cast<std::size_t>(pairs.first[p])]++] = static_cast<std::uint32_t>(2 * p);
      pairs.incident[next[static_cast<std::size_t>(pairs.second[p])]++] = static_cast<std::uint32_t>(2 * p + 1);
    }
  }

  void find_wall_rows() {
    for (std::size_t w = 0; w < wall_count; ++w) {
      wall_rows& wall = walls[w];
      wall.grain.clear();
      for (std::size_t k = 0; k < size(); ++k) {
        const double x = w / 2 == 0 ? place[k].a : w / 2 == 1 ? place[k].b : place[k].c;
        if ((w % 2 == 1 ? edge(w / 2) - x : x) - place[k].d < skin_) wall.grain.push_back(static_cast<std::int32_t>(k));
      }
      wall.count = wall.grain.size();
      if (wall.count > 0) wall.grain.resize(pendular::padded(wall.count), wall.grain.back());
    }
  }

  double edges_[3];
  double time_step_, gravity_, skin_, largest_ = 0;
  std::vector<quad> listed_at_;
  std::int64_t counts_[3] = {1, 1, 1};
  std::vector<std::size_t> cell_start_;
};

/// The row of every entry in the list before, whose origin is given, or `otherwise`.
template <class T>
void carry(std::vector<T>& column, const rows& origin, std::size_t size, const T& otherwise) {
  std::vector<T> moved(size, otherwise);
  for (std::size_t p = 0; p < origin.size(); ++p) {
    if (origin[p] >= 0) moved[p] = column[static_cast<std::size_t>(origin[p])];
  }
  column.swap(moved);
}

}  // namespace yardstick
