// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace pendular {

/// Which pairs a homogeneous distribution may wet, and what it leaves on the grains.
struct bond_selection {
  /// One pair in so many is kept, chosen by the ids of the grains and the seed alone (Richefeu et al. 2007, section
  /// 3.2.2: "two times less bonds" is thinning = 2).
  double thinning = 1;
  std::uint64_t seed = 0;
  /// Pairs farther apart get nothing, m; 0 wets touching pairs only.
  double widest_gap = std::numeric_limits<double>::infinity();
  /// Of the film that fills the roughness of a grain before any bridge exists, m: 4 pi R^2 of it stays on the grain.
  /// That bridges begin at a liquid content which the roughness sets is an observation of Geromichalos et al. 2003
  /// (arXiv:cond-mat/0307762); that it is one full film is our choice (docs/explanation/liquid.md).
  double film_thickness = 0;

  bool keeps(std::int64_t id_i, std::int64_t id_j) const {
    if (thinning <= 1) return true;
    const auto low = static_cast<std::uint64_t>(id_i < id_j ? id_i : id_j);
    const auto high = static_cast<std::uint64_t>(id_i < id_j ? id_j : id_i);
    const std::uint64_t mixed = mix(mix(mix(seed) ^ low) ^ high);
    return static_cast<double>(mixed >> 11) * 0x1p-53 * thinning < 1.0;
  }
  bool reaches(double gap) const { return gap <= widest_gap; }
  /// Of a grain of this radius, m3.
  double held_film(double radius) const { return 4 * std::numbers::pi * radius * radius * film_thickness; }

 private:
  // SplitMix64 finaliser (Steele, Lea and Flood 2014, OOPSLA, section 4).
  static std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
};

inline void validate(const bond_selection& s) {
  constexpr auto page = "docs/reference/liquid.md";
  expects(s.thinning >= 1 && s.thinning < 1e6, "the thinning of bonds", s.thinning, "in [1, 1e6)", page);
  expects(s.widest_gap >= 0, "the widest gap that is wetted (m)", s.widest_gap, "at least 0", page);
  expects(s.film_thickness >= 0 && s.film_thickness < 1, "the thickness of the film on a grain (m)", s.film_thickness,
          "at least 0 and less than 1", page);
}

}  // namespace pendular
