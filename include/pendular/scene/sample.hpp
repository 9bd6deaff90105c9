// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/space/grains.hpp>

#include <range/v3/algorithm/sort.hpp>
#include <range/v3/numeric/accumulate.hpp>
#include <range/v3/range/conversion.hpp>
#include <range/v3/view/take.hpp>
#include <range/v3/view/transform.hpp>
#include <range/v3/view/zip_with.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

namespace pendular::scene {

/// Volume of all grains, m3.
template <class Grains>
double solid_volume(const Grains& g) {
  const auto radius = g.template get<column::radius>();
  const auto cubes = radius | ::ranges::views::transform([](double r) { return r * r * r; });
  return 4.0 / 3.0 * std::numbers::pi * ::ranges::accumulate(cubes, 0.0);
}

/// Height above z = 0 of the highest point of every grain, from the top down, m.
template <class Grains>
std::vector<double> tops(const Grains& g) {
  const auto position = g.template get<column::position>();
  const auto radius = g.template get<column::radius>();
  const auto top = [](const vector& x, double r) { return x.z + r; };
  auto heights = ::ranges::views::zip_with(top, position, radius) | ::ranges::to<std::vector<double>>();
  ::ranges::sort(heights, std::greater<>{});
  return heights;
}

/// Height of the upper surface: mean over the highest hundredth of the grains, m.
template <class Grains>
double surface_height(const Grains& g) {
  const std::vector<double> heights = tops(g);
  const std::size_t count = std::max<std::size_t>(1, heights.size() / 100);
  return ::ranges::accumulate(heights | ::ranges::views::take(count), 0.0) / static_cast<double>(count);
}

/// Height of the centre of mass, m.
template <class Grains>
double mass_centre_height(const Grains& g) {
  const auto position = g.template get<column::position>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  double moment = 0, mass = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    moment += position[k].z / inverse_mass[k];
    mass += 1 / inverse_mass[k];
  }
  return moment / mass;
}

/// Positions in the order of the ids.
template <class Grains>
std::vector<vector> positions_by_id(const Grains& g) {
  const auto position = g.template get<column::position>();
  const auto rows = g.rows_by_id();
  return rows | ::ranges::views::transform([&](std::size_t row) { return position[row]; }) |
         ::ranges::to<std::vector<vector>>();
}

/// As the user would add them again, in the order of the ids.
template <class Grains>
std::vector<grain> grains_by_id(const Grains& g) {
  const auto rows = g.rows_by_id();
  return rows | ::ranges::views::transform([&](std::size_t row) { return g[row]; }) |
         ::ranges::to<std::vector<grain>>();
}

/// Adds grains that start at rest, with as many times their inertia.
template <class System>
void add_at_rest(System& s, const std::vector<grain>& grains, double mass_scaling) {
  for (grain g : grains) {
    g.density *= mass_scaling;
    g.velocity = g.angular_velocity = {0, 0, 0};
    s.add(g);
  }
}

/// Liquid that is here over what was introduced, 1 where there never was any.
template <class System>
double liquid_kept(const System& s) {
  if constexpr (System::wet) {
    const auto& book = s.bridges().book();
    if (book.introduced() > 0) return book.total() / book.introduced();
  }
  return 1;
}

/// The parameters of a scene, after they were looked at. Errors: input_error.
template <class Parameters>
const Parameters& checked(const Parameters& p) {
  validate(p);
  return p;
}

}  // namespace pendular::scene
