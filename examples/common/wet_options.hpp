// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/selection.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace examples {

/// Laws, liquid and the steps they are integrated in.
struct wet_options {
  double water_content = 0.02;
  std::string protocol = "homogeneous";
  std::string law = "richefeu";
  std::string friction = "coulomb-spring";
  double tangential_viscosity = 1;  // gamma_t of Eq. 12, N s/m
  double stiffness = 1000;          // k_n, N/m; a tangential spring has 0.8 of it
  double thinning = 1;
  double widest_gap = std::numeric_limits<double>::infinity();  // of the pairs that are wetted, m
  double film_thickness = 0;                                    // that stays on the grains, m
  double surface_tension_force = 0.4;                           // kappa = 2 pi gamma_s cos(theta), N/m
  double time_step = 8e-6;  // s, of the test; the preparation has time_step / sqrt(mass_scaling)
  double mass_scaling = 4;
  std::optional<double> skin;  // of the neighbour list, in units of the smallest radius; results do not depend on it

  /// Eq. 12, the companion paper's time step, mass as it is.
  void take_from_paper();
  double preparation_time_step() const;
  pendular::bond_selection selection(std::uint64_t seed) const { return {thinning, seed, widest_gap, film_thickness}; }
  /// What decides which composition runs: the law, or with the paper's law the friction.
  const std::string& composition() const { return law == "richefeu" ? friction : law; }
};

/// All of it in one line.
std::string physics_of(const wet_options& o);

/// What differs from the paper, a line each.
std::vector<std::string> departures_of(const wet_options& o);

}  // namespace examples
