// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measured.hpp"
#include "run.hpp"

#include <pendular/observe/coulomb_fit.hpp>

#include <vector>

namespace paper {

/// Residual states of samples that differ by normal stress and seed, and the Coulomb lines through them.
struct locus {
  std::vector<double> lid, plane, shear;  // Pa; the plane between the halves bears weight besides the lid
  pendular::observe::coulomb_line over_lid, over_plane;
  measured bridges;  // per grain when the shear starts
};

locus locus_of(const std::vector<seeds>& normal_stresses);

/// The same of the shear stress at its peak.
locus peak_locus_of(const std::vector<seeds>& normal_stresses);

}  // namespace paper
