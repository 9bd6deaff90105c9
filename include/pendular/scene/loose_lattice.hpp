// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/space/cell_grid.hpp>
#include <pendular/space/grains.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pendular::scene {

/// Grains apart from each other, and the cubic box about the origin that holds them.
struct lattice {
  std::vector<grain> grains;
  box room;
};

namespace detail {
/// As many sites of a cube with n sites along an edge as are wanted, chosen at random; -1 to 1 along each axis.
template <class Random>
std::vector<vector> cube_sites(std::int64_t n, std::size_t wanted, Random& random) {
  std::vector<vector> sites;
  const auto place = [&](std::int64_t k) { return static_cast<double>(2 * k + 1 - n) / static_cast<double>(n); };
  for (std::int64_t k = 0; k < n * n * n; ++k) sites.push_back({place(k % n), place(k / n % n), place(k / (n * n))});
  // Not std::shuffle: its result differs between standard libraries.
  for (std::size_t k = sites.size(); k > 1; --k) {
    std::swap(sites[k - 1], sites[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(random)]);
  }
  sites.resize(wanted);
  return sites;
}
}  // namespace detail

/// A loose cubic lattice in disorder: every grain somewhere in a cell of its own, with a random velocity of at most
/// `agitation` along each axis, m/s. Errors: input_error without grains.
inline lattice loose_lattice(const std::vector<double>& diameters, double density, double agitation,
                             std::uint64_t seed) {
  expects(!diameters.empty(), "the number of grains", 0, "at least 1", "docs/reference/scenes.md");
  const double largest = *std::max_element(diameters.begin(), diameters.end());
  const double spacing = 1.25 * largest;  // room for a quarter of disorder; the box is filled by a seventh or so
  // Not the numbers that mixed the diameters: the same shuffle once more would sort the grains by size along z.
  constexpr std::uint64_t other = 0x9e3779b97f4a7c15u;
  boost::random::mt19937_64 random(seed ^ other);
  boost::random::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&](double most) {
    const double x = most * unit(random), y = most * unit(random), z = most * unit(random);
    return vector{x, y, z};
  };
  std::int64_t n = 1;
  while (static_cast<std::size_t>(n * n * n) < diameters.size()) ++n;
  const double half = 0.5 * static_cast<double>(n) * spacing;
  lattice loose{{}, {{-half, -half, -half}, {half, half, half}}};
  for (const vector& site : detail::cube_sites(n, diameters.size(), random)) {
    const double d = diameters[loose.grains.size()];
    const vector place = half * site + any(0.49 * (spacing - d));
    loose.grains.push_back({place, 0.5 * d, density, any(agitation)});
  }
  return loose;
}

}  // namespace pendular::scene
