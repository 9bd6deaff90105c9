// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <pendular/scene/box_packing.hpp>
#include <pendular/scene/stages.hpp>

/// Compacts the grains, or goes on doing so, or takes the packing that the options name.
pendular::scene::boxed_packing prepare(const options& o, const examples::restart& from,
                                       const pendular::scene::monitor& watch);

// One source file for each composition, so that they compile side by side.
void run_with_viscous_coulomb(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
void run_with_coulomb_spring(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
