// SPDX-License-Identifier: BSD-3-Clause
#include "wet_options.hpp"

#include "departures.hpp"

#include <cmath>
#include <sstream>

namespace examples {

void wet_options::take_from_paper() {
  friction = "viscous-coulomb";
  time_step = 1e-6;
  mass_scaling = 1;
}

double wet_options::preparation_time_step() const { return time_step / std::sqrt(mass_scaling); }

std::string physics_of(const wet_options& o) {
  std::ostringstream text;
  text.precision(17);
  text << "water-content " << o.water_content << " protocol " << o.protocol << " law " << o.law << " friction "
       << o.friction << " tangential-viscosity " << o.tangential_viscosity << " stiffness " << o.stiffness
       << " thinning " << o.thinning << " widest-gap " << o.widest_gap << " film-thickness " << o.film_thickness
       << " kappa " << o.surface_tension_force << " time-step " << o.time_step << " mass-scaling " << o.mass_scaling;
  return text.str();
}

std::vector<std::string> departures_of(const wet_options& o) {
  departures list;
  list.add(o.friction == "coulomb-spring",
           "friction: tangential spring of 0.8 k_n with Coulomb limit; the paper has Eq. 12");
  list.add(o.tangential_viscosity != 1 && o.friction != "coulomb-spring",
           "friction: gamma_t = ", o.tangential_viscosity, " N s/m; the companion paper has 1");
  list.add(o.stiffness != 1000, "stiffness: k_n = ", o.stiffness, " N/m; the companion paper has 1000");
  list.add(o.friction == "viscous-coulomb", "friction: Eq. 12 in this library's form that is stable at any step");
  list.add(o.time_step != 1e-6, "time step: ", o.time_step, " s; the companion paper has 1e-6 s");
  list.add(o.mass_scaling != 1, "mass: inertia times ", o.mass_scaling,
           " in the test, weight as it is; the paper gives no factor");
  list.add(o.law != "richefeu" && o.water_content > 0, "capillary law: ", o.law, "; the paper has Eqs. 4-11");
  list.add(o.thinning != 1, "bonds: one in ", o.thinning, " kept");
  list.add(o.widest_gap == 0, "bonds: between touching grains only; the paper has all eligible pairs");
  list.add(o.widest_gap > 0 && std::isfinite(o.widest_gap), "bonds: across gaps up to ", o.widest_gap,
           " m; the paper has all eligible pairs");
  list.add(o.film_thickness > 0, "films: ", o.film_thickness, " m stay on the grains; the paper has all in bonds");
  list.add(o.surface_tension_force != 0.4, "kappa: ", o.surface_tension_force, " N/m; the companion paper has 0.4");
  list.add(true, "damping: two-sided in contact, sign of Eq. 3 corrected (companion paper)");
  list.add(true, "time step rule: 10 % of pi sqrt(m/k) for the paper's \"10 % below\"");
  return list.lines();
}

}  // namespace examples
