// SPDX-License-Identifier: BSD-3-Clause
// What a neighbour list costs for grains of different sizes, against equal ones measured in turns: grid, order and list as
// a run makes them. Grains lie at random, as dense as in a packing; they overlap, which a list does not mind.
#include "median.hpp"
#include "stopwatch.hpp"

#include <pendular/space/pair_list.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace {
using namespace pendular;

constexpr double solid_fraction = 0.6, nearest = 0.75;  // least distance over the sum of the radii
constexpr double range = 0.3;                           // over the smallest radius, which is 1
constexpr int rounds = 15;

struct cloud {
  std::vector<vector> position;
  std::vector<double> radius;
  std::vector<std::int64_t> id;

  void add(const vector& p, double r) {
    position.push_back(p);
    radius.push_back(r);
    id.push_back(static_cast<std::int64_t>(id.size()));
  }

  template <class Column>
  static void permute(Column& column, const std::vector<std::size_t>& order) {
    const Column before = column;
    for (std::size_t k = 0; k < order.size(); ++k) column[k] = before[order[k]];
  }
};

/// Puts the largest grains first, each where it is not too near to another; the place of every grain is listed in all cells it meets.
class deposit {
 public:
  explicit deposit(double side, double edge)
      : side_(side), edge_(edge), across_(static_cast<std::size_t>(side / edge) + 1) {
    cells_.resize(across_ * across_ * across_);
  }

  bool is_free(const cloud& c, const vector& p, double r) const {
    bool free = true;
    for_cells(p, r, [&](std::size_t cell) {
      for (const std::size_t k : cells_[cell]) free = free && norm(c.position[k] - p) > nearest * (c.radius[k] + r);
    });
    return free;
  }

  void put(cloud& c, const vector& p, double r) {
    for_cells(p, r, [&](std::size_t cell) { cells_[cell].push_back(c.id.size()); });
    c.add(p, r);
  }

 private:
  template <class Visit>
  void for_cells(const vector& p, double r, const Visit& visit) const {
    const auto at = [&](double x) { return static_cast<std::size_t>(std::clamp(x, 0.0, side_) / edge_); };
    for (auto z = at(p.z - r); z <= at(p.z + r); ++z) {
      for (auto y = at(p.y - r); y <= at(p.y + r); ++y) {
        for (auto x = at(p.x - r); x <= at(p.x + r); ++x) visit((z * across_ + y) * across_ + x);
      }
    }
  }

  double side_, edge_;
  std::size_t across_;
  std::vector<std::vector<std::size_t>> cells_;
};

/// `of_share` makes radii of numbers from 0 to 1; `more` are large grains among them.
cloud packed(std::size_t grains, const std::function<double(double)>& of_share, const std::vector<double>& more = {}) {
  boost::random::mt19937_64 random(1);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> radii;
  for (std::size_t k = 0; k < grains; ++k) radii.push_back(of_share(unit(random)));
  const auto solid = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0,
                           [](double sum, double r) { return sum + 4.0 / 3.0 * std::numbers::pi * r * r * r; });
  };
  const double side = std::cbrt(solid(radii) / solid_fraction + solid(more));
  radii.insert(radii.end(), more.begin(), more.end());
  std::sort(radii.rbegin(), radii.rend());
  deposit bed(side, std::max(2.5, side / 100));
  cloud c;
  for (const double r : radii) {
    vector p;
    do p = vector{r, r, r} + (side - 2 * r) * vector{unit(random), unit(random), unit(random)};
    while (!bed.is_free(c, p, r));
    bed.put(c, p, r);
  }
  return c;
}

/// Grains and their list.
class listing {
 public:
  explicit listing(cloud c) : cloud_(std::move(c)) { again(); }

  /// The list made anew after the grains have moved a little, s.
  double again() {
    for (vector& p : cloud_.position) p += 0.1 * range * vector{unit_(random_), unit_(random_), unit_(random_)};
    return processor_time([&] { list(); });
  }
  std::size_t pairs() const { return list_.size(); }
  std::size_t grains() const { return cloud_.id.size(); }

 private:
  void list() {
    const graded_grid grid(cloud_.position, cloud_.radius, range);
    const auto order = grid.order(cloud_.id);
    cloud::permute(cloud_.position, order);
    cloud::permute(cloud_.radius, order);
    cloud::permute(cloud_.id, order);
    list_.rebuild(cloud_.position, cloud_.radius, cloud_.id, grid, range, 0.5 * range, order);
  }

  cloud cloud_;
  pair_list list_;
  boost::random::mt19937_64 random_{2};
  boost::random::uniform_real_distribution<double> unit_{-1, 1};
};

/// What is measured, equal grains first.
std::vector<std::pair<std::string, listing>> scenes_of(std::size_t grains) {
  const auto equal = [](double) { return 1.0; };
  cloud outside = packed(grains, equal);
  outside.add({-1000, -1000, -1000}, 30);
  std::vector<std::pair<std::string, listing>> scenes;
  scenes.emplace_back("equal", packed(grains, equal));
  scenes.emplace_back("one of 30 times the radius among them", packed(grains, equal, {30}));
  scenes.emplace_back("ten of 10 times the radius among them", packed(grains, equal, std::vector<double>(10, 10)));
  scenes.emplace_back("one of 30 times the radius far outside", outside);
  scenes.emplace_back("1 to 2, uniform", packed(grains, [](double share) { return 1 + share; }));
  scenes.emplace_back("1 to 4, uniform", packed(grains, [](double share) { return 1 + 3 * share; }));
  scenes.emplace_back("1 to 30, uniform in the logarithm",
                      packed(grains, [](double share) { return std::pow(30.0, share); }));
  return scenes;
}
}  // namespace

int main(int count, char** arguments) {
  const std::size_t grains = count > 1 ? std::stoul(arguments[1]) : 16000;
#ifdef _OPENMP
  omp_set_num_threads(1);
#endif
  auto scenes = scenes_of(grains);
  std::vector<std::vector<double>> times(scenes.size()), ratios(scenes.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      times[k].push_back(scenes[k].second.again());
      ratios[k].push_back(times[k].back() / times[0].back());
    }
  }
  std::printf("| grains | number | pairs | list, ms | over that of equal ones |\n|---|---|---|---|---|\n");
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const auto& [name, scene] = scenes[k];
    std::printf("| %s | %zu | %zu | %.1f | %.2f |\n", name.c_str(), scene.grains(), scene.pairs(),
                1e3 * median(times[k]), median(ratios[k]));
  }
}
