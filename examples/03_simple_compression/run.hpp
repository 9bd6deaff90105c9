// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <pendular/io/checkpoint.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/scene/packing.hpp>

#include <optional>

/// The checkpoint to go on from, if any.
using restart = std::optional<pendular::io::checkpoint_reader>;

/// Deposits and seals, or goes on doing so; nothing to do if the checkpoint is of a later stage.
pendular::scene::sealed_packing prepare(const options& o, const restart& from, const pendular::scene::monitor& watch);

// One source file per friction law, so that they compile side by side.
void run_test(const options& o, const pendular::friction::coulomb_spring& friction, const restart& from,
              const pendular::scene::monitor& watch);
void run_test(const options& o, const pendular::friction::viscous_coulomb& friction, const restart& from,
              const pendular::scene::monitor& watch);
void run_test(const options& o, const pendular::friction::viscous_coulomb_explicit& friction, const restart& from,
              const pendular::scene::monitor& watch);
