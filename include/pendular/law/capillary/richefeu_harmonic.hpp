// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/richefeu_with.hpp>
#include <pendular/law/mean_radius/harmonic.hpp>

namespace pendular::capillary {

/// The law of `richefeu` with the harmonic (Derjaguin) mean radius R = 2 R_i R_j / (R_i + R_j) in the amplitude, which
/// Laplace-Young supports as V_b goes to 0; decay length and the rest as printed.
/// Units: N from N/m, m, m3. Valid for any size ratio at contact; the gap dependence is that of Eq. 11.
/// Source: Richefeu et al. 2007, Eqs. 4-11, with the mean radius of B. V. Derjaguin, Kolloid-Z. 69, 155 (1934).
using richefeu_harmonic = richefeu_with<mean_radius::harmonic>;

}  // namespace pendular::capillary
