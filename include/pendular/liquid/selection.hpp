// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <cstdint>

namespace pendular {

/// Which pairs may carry a bond at all: thinning by a factor keeps one in `thinning`, chosen by the ids of the grains
/// and the seed alone (Richefeu et al. 2007, section 3.2.2: "two times less bonds" is thinning = 2).
struct bond_selection {
  double thinning = 1;
  std::uint64_t seed = 0;

  bool keeps(std::int64_t id_i, std::int64_t id_j) const {
    if (thinning <= 1) return true;
    const auto low = static_cast<std::uint64_t>(id_i < id_j ? id_i : id_j);
    const auto high = static_cast<std::uint64_t>(id_i < id_j ? id_j : id_i);
    const std::uint64_t mixed = mix(mix(mix(seed) ^ low) ^ high);
    return static_cast<double>(mixed >> 11) * 0x1p-53 * thinning < 1.0;
  }

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
  expects(s.thinning >= 1 && s.thinning < 1e6, "the thinning of bonds", s.thinning, "in [1, 1e6)",
          "docs/reference/liquid.md");
}

}  // namespace pendular
