// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include "../common/facts.hpp"

#include <pendular/scene/shear_result.hpp>

/// Writes summary.json, shear_curve.csv and shear_curve.png, and prints the summary.
void report(const options& o, const pendular::scene::shear_result& result, const examples::run_facts& facts);
