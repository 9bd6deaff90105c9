// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "microstructure.hpp"
#include "options.hpp"

#include <nlohmann/json_fwd.hpp>

/// forces.csv and pressures.csv: probability densities of f / f0 and p / p0, compression positive.
void write_densities(const options& o, const microstructure& m);
/// forces.png and pressures.png.
void draw_densities(const options& o, const microstructure& m);

/// The numbers of summary.json and, where it prints one, the companion paper's.
void print_beside_the_paper(const nlohmann::ordered_json& summary);
