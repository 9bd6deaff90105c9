// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

// Dense packings for measurements: a box of 8000 grains of 0.8 to 1.3 mm under a lid, and larger or smaller ones of parts
// and copies of it.
namespace packing {

using namespace pendular;

struct sample {
  std::vector<grain> grains;
  vector size{0, 0, 0};  // of the box, m
};

/// Six planes around the box; the lid last.
template <class Drive>
auto box_of(const vector& size, const Drive& lid) {
  using boundary::plane;
  using boundary::wall;
  return boundary::walls{wall{plane{{0, 0, 0}, {1, 0, 0}}}, wall{plane{{size.x, 0, 0}, {-1, 0, 0}}},
                         wall{plane{{0, 0, 0}, {0, 1, 0}}}, wall{plane{{0, size.y, 0}, {0, -1, 0}}},
                         wall{plane{{0, 0, 0}, {0, 0, 1}}}, wall{plane{{0, 0, size.z}, {0, 0, -1}}, lid}};
}

/// edge^3 grains, settled without friction under 300 Pa; 8000 take about a minute.
inline sample settled(int edge = 20, int steps = 60000) {
  constexpr double spacing = 1.32e-3;
  const double side = 1.02e-3 * edge, top = spacing * 1.4 * edge;
  boost::random::mt19937 random(1);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  pendular::system s{
      material{normal::linear{1e3}, damping::viscous{0.5}},
      box_of({side, side, top}, boundary::servo_stress{300, side * side, side * side, 1000 * side * side}),
      half_step_velocity_verlet{4e-6, {0, 0, -9.81}}, run_options{.force = true}};
  const int across = static_cast<int>(side / spacing);
  for (int k = 0; k < edge * edge * edge; ++k) {
    const double x = k % across, y = k / across % across, z = k / (across * across);
    const double r = 0.5 * (0.8e-3 + 0.5e-3 * unit(random));
    const vector shift{unit(random), unit(random), unit(random)};
    const double free = spacing - 2 * r;
    s.add({.position = spacing * vector{x, y, z} + vector{r, r, r} + free * shift, .radius = r, .density = 2700});
  }
  boundary::get<5>(s.walls()).shape.point.z = spacing * (edge * edge * edge / (across * across) + 2);
  s.run(steps);
  sample done;
  for (const std::size_t row : s.particles().rows_by_id()) {
    grain g = s.particles()[row];
    g.velocity = {0, 0, 0};
    done.grains.push_back(g);
  }
  done.size = {side, side, boundary::get<5>(s.walls()).shape.point.z};
  return done;
}

inline void write(const sample& s, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto put = [&](double v) { out.write(reinterpret_cast<const char*>(&v), sizeof v); };
  for (const double v : {s.size.x, s.size.y, s.size.z}) put(v);
  for (const grain& g : s.grains) {
    for (const double v : {g.position.x, g.position.y, g.position.z, g.radius, g.density}) put(v);
  }
}

inline sample read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const auto get = [&] {
    double v = 0;
    in.read(reinterpret_cast<char*>(&v), sizeof v);
    return v;
  };
  sample s;
  s.size = {get(), get(), get()};
  while (in.peek() != std::char_traits<char>::eof()) {
    const vector x{get(), get(), get()};
    const double r = get(), density = get();
    s.grains.push_back({.position = x, .radius = r, .density = density});
  }
  return s;
}

inline sample block(const std::filesystem::path& kept) {
  if (!std::filesystem::exists(kept)) write(settled(), kept);
  return read(kept);
}

/// Copies of the block side by side until there are at least so many grains; the lowest grains of one block if it has
/// more than are asked for.
inline sample of_size(const sample& block, std::size_t grains) {
  if (grains <= block.grains.size()) {
    sample part = block;
    std::sort(part.grains.begin(), part.grains.end(),
              [](const grain& a, const grain& b) { return a.position.z < b.position.z; });
    part.grains.resize(grains);
    part.size.z = 0;
    for (const grain& g : part.grains) part.size.z = std::max(part.size.z, g.position.z + g.radius);
    return part;
  }
  const double blocks = std::ceil(static_cast<double>(grains) / static_cast<double>(block.grains.size()));
  const int n = static_cast<int>(std::cbrt(blocks) + 1e-9), layers = static_cast<int>(std::ceil(blocks / (n * n)));
  sample all;
  all.size = {n * block.size.x, n * block.size.y, layers * block.size.z};
  for (int k = 0; k < n * n * layers; ++k) {
    const vector shift{block.size.x * (k % n), block.size.y * (k / n % n), block.size.z * (k / (n * n))};
    for (grain g : block.grains) {
      g.position += shift;
      all.grains.push_back(g);
    }
  }
  return all;
}

}  // namespace packing
