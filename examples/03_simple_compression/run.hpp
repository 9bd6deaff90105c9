// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <pendular/scene/packing.hpp>

/// Deposits and seals, or goes on doing so; nothing to do if the checkpoint is of a later stage.
pendular::scene::sealed_packing prepare(const options& o, const examples::restart& from,
                                        const pendular::scene::monitor& watch);

// One source file for each composition, so that they compile side by side. Spring friction where nothing is said.
void run_with_coulomb_spring(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
void run_with_viscous_coulomb(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
void run_with_viscous_coulomb_explicit(const options& o, const examples::restart& from,
                                       const pendular::scene::monitor& watch);
void run_with_richefeu_harmonic(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
void run_with_willett(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
void run_with_laplace_young(const options& o, const examples::restart& from, const pendular::scene::monitor& watch);
