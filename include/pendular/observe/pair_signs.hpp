// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/observe/pairs.hpp>
#include <pendular/observe/probability_density.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace pendular::observe {

/// How many neighbours press a grain and how many pull it, k+ and k- of Richefeu et al. 2006 (Eur. Phys. J. E 21, 359),
/// section 4: by the sign of the total normal force. Pairs without force and walls do not count.
struct pair_signs {
  int compressive = 0;
  int tensile = 0;
};

/// Of every grain, in the order of ids. Of a system whose forces have been evaluated.
template <class System>
std::vector<pair_signs> pair_signs_of(const System& s) {
  std::vector<pair_signs> by_row(s.particles().size()), signs;
  for (const pair& p : pairs(s)) {
    const double push = p.push();
    for (const std::size_t row : {p.rows.first, p.rows.second}) {
      by_row[row].compressive += push > 0 ? 1 : 0;
      by_row[row].tensile += push < 0 ? 1 : 0;
    }
  }
  for (const std::size_t row : s.particles().rows_by_id()) signs.push_back(by_row[row]);
  return signs;
}

/// What every class (k+, k-) adds to the mean of a quantity over all grains, in row k+ and column k-: the joint
/// distribution rho(k+, k-) for the quantity 1, the partial pressures of the companion paper's section 5 for the
/// pressure. The entries add up to the mean; a matrix without entries for no grains.
/// Errors: not as many values as grains.
inline Eigen::MatrixXd class_shares(std::span<const pair_signs> signs, std::span<const double> values) {
  expects(signs.size() == values.size(), "the number of values", static_cast<double>(values.size()),
          "that of the grains", "docs/reference/observe.md");
  int most = -1;
  for (const pair_signs& k : signs) most = std::max({most, k.compressive, k.tensile});
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(most + 1, most + 1);
  for (std::size_t g = 0; g < signs.size(); ++g) {
    shares(signs[g].compressive, signs[g].tensile) += values[g] / static_cast<double>(signs.size());
  }
  return shares;
}

/// Mean k+ and k- of the grains whose value lies in a bin.
struct mean_signs {
  double compressive = 0;
  double tensile = 0;
  std::size_t grains = 0;
};

/// For every bin between the edges; a value on an edge counts above it, one on the last edge below.
/// Errors: as probability_density, or not as many values as grains.
inline std::vector<mean_signs> signs_by_class(std::span<const pair_signs> signs, std::span<const double> values,
                                              std::span<const double> edges) {
  detail::expect_bins(edges);
  expects(signs.size() == values.size(), "the number of values", static_cast<double>(values.size()),
          "that of the grains", "docs/reference/observe.md");
  std::vector<mean_signs> bins(edges.size() - 1);
  for (std::size_t g = 0; g < signs.size(); ++g) {
    if (!(values[g] >= edges.front() && values[g] <= edges.back())) continue;
    const auto above = std::upper_bound(edges.begin(), edges.end() - 1, values[g]);
    mean_signs& bin = bins[static_cast<std::size_t>(above - edges.begin()) - 1];
    bin.compressive += signs[g].compressive;
    bin.tensile += signs[g].tensile;
    ++bin.grains;
  }
  for (mean_signs& bin : bins) {
    const double grains = std::max<double>(1, static_cast<double>(bin.grains));
    bin.compressive /= grains, bin.tensile /= grains;
  }
  return bins;
}

}  // namespace pendular::observe
