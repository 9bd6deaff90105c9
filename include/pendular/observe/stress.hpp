// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/as_eigen.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/observe/pairs.hpp>
#include <pendular/space/grains.hpp>

#include <Eigen/Core>
#include <range/v3/algorithm/count_if.hpp>
#include <range/v3/numeric/accumulate.hpp>
#include <range/v3/view/transform.hpp>

#include <cstddef>

namespace pendular::observe {

/// Love-Weber stress, Pa, compression positive: (1/V) sum of force times branch over all pairs, bridges across a gap
/// included. Static part only. Valid for a volume, m3, that holds all grains. Errors: input_error for one that is none.
/// Source: A. E. H. Love, Treatise on the Mathematical Theory of Elasticity (1927), p. 618; Richefeu et al. 2006, section 5.
template <class System>
Eigen::Matrix3d love_weber_stress(const System& s, double volume) {
  expects_positive("the volume over which a stress is taken (m3)", volume, "docs/reference/observe.md");
  const auto moment = [](const pair& p) -> Eigen::Matrix3d {
    // The force on grain i points along -branch in compression.
    return -as_eigen(p.force) * as_eigen(p.branch).transpose();
  };
  const Eigen::Matrix3d zero = Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d sum =
      ::ranges::accumulate(pairs(s) | ::ranges::views::transform(moment), zero,
                           [](const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) -> Eigen::Matrix3d { return a + b; });
  return sum / volume;
}

/// Mean force sum on a grain over the mean size of the pair forces: how far the packing is from equilibrium.
template <class System>
double unbalanced_force_ratio(const System& s) {
  const auto force = s.particles().template get<column::force>();
  const auto inverse_mass = s.particles().template get<column::inverse_mass>();
  const auto sizes = pairs(s) | ::ranges::views::transform([](const pair& p) { return norm(p.force); });
  const auto acting = ::ranges::count_if(sizes, [](double size) { return size > 0; });
  double net = 0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    net += norm(force[k] + (1 / inverse_mass[k]) * s.integrator().gravity);
  }
  if (acting == 0) return 0;
  return net / static_cast<double>(force.size()) / (::ranges::accumulate(sizes, 0.0) / static_cast<double>(acting));
}

}  // namespace pendular::observe
