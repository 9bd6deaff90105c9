// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>

#include <Eigen/Core>

namespace pendular {

inline Eigen::Vector3d as_eigen(const vector& a) { return {a.x, a.y, a.z}; }

}  // namespace pendular
