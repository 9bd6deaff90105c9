// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "microstructure.hpp"
#include "options.hpp"

#include "../common/facts.hpp"

#include <pendular/scene/cohesive_result.hpp>

/// Writes summary.json, relaxation.csv, forces.csv, pressures.csv, classes.csv, forces.png and pressures.png, and
/// prints the summary with the companion paper's numbers beside.
void report(const options& o, const pendular::scene::cohesive_result& result, const microstructure& m,
            const examples::run_facts& facts);
