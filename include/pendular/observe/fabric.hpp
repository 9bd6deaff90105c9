// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/as_eigen.hpp>
#include <pendular/observe/pairs.hpp>

#include <Eigen/Core>
#include <range/v3/view/filter.hpp>

#include <cstddef>

namespace pendular::observe {

/// What joins two grains: that they touch, or liquid, touching or not.
enum class links { contacts, bridges };

/// Mean of n (x) n over the pairs that are linked, walls not counted; the trace is 1. Zero if there is no such pair.
/// Source: M. Satake, Fabric tensor in granular materials, in Deformation and Failure of Granular Materials (1982).
template <class System>
Eigen::Matrix3d fabric_tensor(const System& s, links by = links::contacts) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  std::size_t count = 0;
  const auto linked = [by](const pair& p) { return by == links::bridges ? bridged(p) : touching(p); };
  for (const pair& p : pairs(s) | ::ranges::views::filter(linked)) {
    const Eigen::Vector3d n = as_eigen(p.normal());
    sum += n * n.transpose();
    ++count;
  }
  if (count > 0) sum /= static_cast<double>(count);
  return sum;
}

}  // namespace pendular::observe
