// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"
#include "still.hpp"

#include "../common/facts.hpp"

#include <pendular/scene/compression_result.hpp>

/// Writes summary.json, stress_strain.csv and stress_strain.png, and prints the summary.
void report(const options& o, const pendular::scene::compression_result& result, const examples::run_facts& facts,
            const still_grains& still);
