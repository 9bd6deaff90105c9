// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../scenes.hpp"

#include <pendular/io/atomic_file.hpp>
#include <pendular/io/number.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace peers {

/// What every code gets: one packing, and what the peers' scripts must know of our scenes.
struct task {
  packing::sample sample;
  int warmup, steps;
  std::filesystem::path data, inflated;  // the packing as a data file, and with diameters larger by the reach
  double rate;                           // of the dashpot, over the reduced mass, 1/s
  double reach;                          // gap below which there are as many pairs as we have bridges, m
  double volume;                         // of a mean bridge, m3
  double bridges;                        // per grain

  double grains() const { return static_cast<double>(sample.grains.size()); }
};

/// A data file of LAMMPS, which LIGGGHTS and YADE read, too.
inline void write_data(const packing::sample& s, const std::filesystem::path& file, double inflated = 0) {
  using pendular::io::shortest;
  std::string text = "packing\n\n" + std::to_string(s.grains.size()) + " atoms\n1 atom types\n";
  text += "0 " + shortest(s.size.x) + " xlo xhi\n0 " + shortest(s.size.y) + " ylo yhi\n";
  text += "0 " + shortest(s.size.z) + " zlo zhi\n\nAtoms\n\n";
  for (std::size_t k = 0; k < s.grains.size(); ++k) {
    const pendular::grain& g = s.grains[k];
    text += std::to_string(k + 1) + " 1";
    for (const double v : {2 * g.radius + inflated, g.density, g.position.x, g.position.y, g.position.z})
      text += " " + shortest(v);
    text += "\n";
  }
  pendular::io::atomic_file out(file);
  out.write(text);
  out.commit();
}

/// 2 alpha_n sqrt(k_n / m) with the reduced mass m of two mean grains: a peer's dashpot knows no other masses.
inline double dashpot_rate(const packing::sample& s) {
  double mass = 0;
  for (const pendular::grain& g : s.grains) mass += 4.0 / 3 * std::numbers::pi * std::pow(g.radius, 3) * g.density;
  mass /= static_cast<double>(s.grains.size());
  return 2 * scenes::damping_rate * std::sqrt(scenes::normal_stiffness / (mass / 2));
}

/// Half-way between the last pair that gets a bridge and the first that does not, when the nearest ones get them.
template <class System>
double reach_of_bridges(const System& s) {
  const std::size_t bridges = s.bridges().count();
  if (bridges == 0 || bridges >= s.pairs().size()) throw std::runtime_error("the packing has no pair without a bridge");
  const auto listed = s.contacts().gap().first(s.pairs().size());
  std::vector<double> gaps(listed.begin(), listed.end());
  std::sort(gaps.begin(), gaps.end());
  return 0.5 * (gaps[bridges - 1] + gaps[bridges]);
}

/// Leaves the data file in the working folder, where the block of grains is.
inline task task_of(const packing::sample& sample, int warmup, int steps) {
  const auto ours = scenes::wet(sample);
  const std::filesystem::path data = "packing_" + std::to_string(sample.grains.size()) + ".data";
  const std::filesystem::path inflated = "packing_" + std::to_string(sample.grains.size()) + "_inflated.data";
  const double reach = reach_of_bridges(ours), bridges = static_cast<double>(ours.bridges().count());
  write_data(sample, data);
  write_data(sample, inflated, reach);
  return {sample,
          warmup,
          steps,
          data,
          inflated,
          dashpot_rate(sample),
          reach,
          ours.bridges().book().introduced() / bridges,
          bridges / static_cast<double>(sample.grains.size())};
}

}  // namespace peers
