// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/richefeu_with.hpp>
#include <pendular/law/mean_radius/geometric.hpp>

namespace pendular::capillary {

/// The explicit capillary force as printed, with R = sqrt(R_i R_j).
/// Units: N from N/m, m, m3. Against Laplace-Young (theta = 0, r = 1) it is 4 to 27 % high at contact for V_b/R^3 in
/// [1e-4, 0.1], 15 to 46 % high at a quarter to half of the rupture distance; the geometric mean radius is 9 to 28 %
/// high at r = 2 and should not be used beyond r = 4 (docs/reference/laws.md).
/// Source: Richefeu et al. 2007, Eqs. 4-11.
using richefeu = richefeu_with<mean_radius::geometric>;

}  // namespace pendular::capillary
