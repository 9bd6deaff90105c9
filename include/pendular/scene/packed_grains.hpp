// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/space/grains.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace pendular::scene {

/// m3
inline double volume_of(const grain& g) { return 4.0 / 3.0 * std::numbers::pi * g.radius * g.radius * g.radius; }

/// Errors: input_error for a grain of a packing that has no size, is larger than its room, has no mass or no place.
inline void expects_solid(const grain& g, double room) {
  constexpr auto page = "docs/reference/scenes.md";
  expects_positive("the radius of a grain in the packing (m)", g.radius, page);
  expects(g.radius <= room, "the radius of a grain in the packing (m)", g.radius, "at most that of its room", page);
  expects_positive("the density of a grain in the packing (kg/m3)", g.density, page);
  for (const double x : {g.position.x, g.position.y, g.position.z}) {
    expects(std::isfinite(x), "the position of a grain in the packing (m)", x, "finite", page);
  }
}

/// Five numbers a grain: position, radius, density.
inline void append(std::vector<double>& numbers, const std::vector<grain>& grains) {
  for (const grain& g : grains) {
    numbers.insert(numbers.end(), {g.position.x, g.position.y, g.position.z, g.radius, g.density});
  }
}

/// What append() was given, from the numbers after the first `head` ones.
inline std::vector<grain> grains_of(const std::vector<double>& n, std::size_t head) {
  std::vector<grain> grains;
  for (std::size_t k = head; k + 4 < n.size(); k += 5) {
    grains.push_back({{n[k], n[k + 1], n[k + 2]}, n[k + 3], n[k + 4]});
  }
  return grains;
}

/// `head` numbers and those of whole grains. Errors: std::runtime_error for another number of them.
inline std::vector<double> packing_numbers(const io::checkpoint_reader& in, const std::string& name, std::size_t head) {
  const auto numbers = in.get<std::vector<double>>(name);
  if (numbers.size() < head || (numbers.size() - head) % 5 != 0) {
    in.refuse("has " + std::to_string(numbers.size()) + " numbers in '" + name + "', where a packing has " +
              std::to_string(head) + " and 5 a grain; make the packing anew");
  }
  return numbers;
}

}  // namespace pendular::scene
