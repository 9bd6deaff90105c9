// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.hpp"

#include <pendular/core/vec.hpp>
#include <pendular/scene/compression_result.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What a snapshot shows, by id of the grains.
struct snapshot {
  double time;  // s
  std::vector<double> x, y, z, radius, displacement, liquid;
  std::vector<double> displacement_x, displacement_y, displacement_z;
  std::vector<std::array<std::int64_t, 2>> bonds;
  std::vector<double> bond_force, bond_volume, bond_gap;
};

/// Everything the summary needs besides the result.
struct run_facts {
  double wall_time = 0;         // of all stages in this program, s
  double compression_time = 0;  // of the compression in this program, s
  std::int64_t compression_steps = 0;
  int threads = 1;
  std::int64_t ruptures = 0, formations = 0;
  std::int64_t outside_capillary_law = 0, outside_rupture_law = 0;  // bridges made beyond the validity of the laws
  double liquid_volume = 0;                                         // introduced, m3
  double largest_bridge = 0;                                        // V_b / R^3 at the end
  double mean_diameter = 0;                                         // m
  std::vector<std::string> limits;                                  // of stability, as checked
  pendular::observe::energies energy_at_end;
};

/// Peak of the curve, smoothed over 20 micrometres of shortening.
struct peak {
  double stress = 0;      // Pa
  double shortening = 0;  // m
  double last = 0;        // smoothed stress at the end, Pa
};
peak find_peak(const std::vector<pendular::scene::compression_record>& records);

/// What differs from the paper, a line each.
std::vector<std::string> departures(const options& o);

/// Writes summary.json, stress_strain.csv and stress_strain.png, and prints the summary.
void report(const options& o, const pendular::scene::compression_result& result, const run_facts& facts);

/// Writes the state for ParaView; the collection is rewritten so that a running job can be looked at.
void write_snapshot(const options& o, const snapshot& s, int number);

/// Ray-traced sample.png and section.png, coloured by displacement (the paper's Figs. 8 and 11).
void draw_sample(const options& o, const snapshot& s, double lid_height);
