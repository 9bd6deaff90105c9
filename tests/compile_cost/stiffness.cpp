// SPDX-License-Identifier: BSD-3-Clause
// What the derivatives of laws may take from elsewhere.
#include "law.cpp"

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>
