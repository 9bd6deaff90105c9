// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loci.hpp"

#include <filesystem>
#include <string>

// Coulomb lines of the direct shear: Fig. 6, and grains of other sizes. Each draws into `figures` and answers tables for the
// page; `folder` is that of the campaign. Errors: std::runtime_error if a job has not come to its end.
namespace paper::shear {

std::string yield_loci(const std::filesystem::path& folder, const std::filesystem::path& figures);
std::string grain_size(const std::filesystem::path& folder);

/// What the bridges of the paper's grading would give as cohesion if all of them pulled with f_0: the tangent of the angle
/// of friction times their isotropic stress, Pa. Source: Rumpf 1962, for several sizes that are not correlated:
/// solid fraction * bridges * kappa <R^3/2> <R^1/2> / (4 pi <R^3>). `any` is one run of the locus.
measured expected_cohesion(const locus& l, const run& any);

}  // namespace paper::shear
