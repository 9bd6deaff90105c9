// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/as_eigen.hpp>
#include <pendular/observe/normal_force.hpp>
#include <pendular/observe/pairs_in_order.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace pendular::observe {

/// What joins two grains: that they touch, or liquid, touching or not.
enum class links { contacts, bridges };

namespace detail {
template <class System>
bool is_linked(const System& s, std::size_t p, links by) {
  if constexpr (System::wet) {
    if (by == links::bridges) return s.bridges().is_bonded(p);
  }
  return by == links::contacts && s.contacts().gap()[p] < 0;
}
}  // namespace detail

/// Mean of n (x) n over the pairs that are linked, walls not counted; the trace is 1. Zero if there is no such pair.
/// Source: M. Satake, Fabric tensor in granular materials, in Deformation and Failure of Granular Materials (1982).
template <class System>
Eigen::Matrix3d fabric_tensor(const System& s, links by = links::contacts) {
  const auto view = s.view();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  std::size_t count = 0;
  for (const std::size_t p : pairs_in_order(s)) {
    if (!detail::is_linked(s, p, by)) continue;
    const Eigen::Vector3d n = as_eigen(pair_normal(view, p));
    sum += n * n.transpose();
    ++count;
  }
  if (count > 0) sum /= static_cast<double>(count);
  return sum;
}

}  // namespace pendular::observe
