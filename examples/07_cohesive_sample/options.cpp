// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "../common/command_line.hpp"
#include "../common/departures.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>

options::options() {
  output = "cohesive_sample";
  water_content = 0.007;
  protocol = "neighbours";  // to the contacts of the same grain, in proportion to their sizes
  friction = "viscous-coulomb";
  time_step = 4e-6;
  mass_scaling = 1;
}

pendular::scene::box_packing_parameters options::preparation() const {
  pendular::scene::box_packing_parameters p;
  p.grains = grains;
  p.pressure = pressure;
  p.unbalanced_force = unbalanced_force;
  p.stress_tolerance = 0.01 * pressure;
  p.time_step = preparation_time_step();
  p.seed = seed;
  p.numerics = {.skin = skin, .force = force};
  return p;
}

double options::largest_pull() const {
  double largest = 0;
  for (const auto& share : preparation().sizes) largest = std::max(largest, 0.5 * share.diameter);
  return surface_tension_force * largest;
}

namespace {

void describe(CLI::App& app, options& o) {
  app.add_option("--preparation-friction", o.preparation_friction,
                 "between grains while they are compacted; 0 is densest")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  app.add_option("--pressure", o.pressure, "of the six walls on the dry grains, Pa")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--confining-pressure", o.confining_pressure, "of the six walls on the wet sample, Pa")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--relaxation", o.relaxation, "of the wet sample, at most, s")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--unbalanced-force", o.unbalanced_force,
                 "mean force on a grain over the mean force of a pair, at which packing and sample are at rest")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--packing", o.packing, "start from packing.bin of an earlier job of as many grains")
      ->check(CLI::ExistingFile);
  app.add_option("--grains", o.grains, "number of grains, in equal numbers of 1, 1.5 and 2 mm")
      ->check(CLI::Range(std::int64_t{100}, std::int64_t{1000000}))
      ->capture_default_str();
}

/// One sentence about what this program does not have, or nothing.
std::string not_built(const options& o) {
  if (o.law != "richefeu") return "--law " + o.law + " is not built into this program, which has richefeu only";
  if (o.friction == "viscous-coulomb-explicit") {
    return "--friction viscous-coulomb-explicit is not built into this program; take viscous-coulomb";
  }
  if (o.protocol == "gravity") return "--protocol gravity has no meaning here: the sample has no gravity";
  if (o.water_content == 0) return "--water-content is 0, but nothing else holds this sample together";
  return {};
}

}  // namespace

std::string options::physics() const {
  std::ostringstream text;
  text.precision(17);
  text << physics_of(*this) << " preparation-friction " << preparation_friction << " pressure " << pressure
       << " confining-pressure " << confining_pressure << " relaxation " << relaxation << " unbalanced-force "
       << unbalanced_force << " packing " << examples::label_of(packing) << " grains " << grains << " seed " << seed
       << " checkpoint-interval " << checkpoint_interval;
  return text.str();
}

std::vector<std::string> options::departures() const {
  examples::departures list(departures_of(*this));
  const options usual;
  list.add(grains != usual.grains, "grains: ", grains, "; the companion paper has 8000");
  list.add(water_content != usual.water_content, "water: w = ", water_content, "; the companion paper has 0.007");
  list.add(protocol != usual.protocol, "protocol: ", protocol,
           "; in the companion paper a broken bridge goes to the contacts of its grains by their sizes");
  list.add(true, "open in the companion paper, chosen here: compacted dry by ", pressure, " Pa with friction ",
           preparation_friction, ", and a walls' stress of ", confining_pressure, " Pa while the wet sample relaxes");
  return list.lines();
}

options read_options(int count, char** arguments) {
  options o;
  CLI::App app("Forces in a cohesive sample (Richefeu et al. 2006, Eur. Phys. J. E 21, 359).");
  examples::describe(app, static_cast<examples::wet_options&>(o));
  describe(app, o);
  examples::describe(app, static_cast<examples::job_options&>(o));
  app.callback({});  // what is built is decided below
  examples::parse(app, "07_cohesive_sample", count, arguments);
  if (const std::string lacking = not_built(o); !lacking.empty()) {
    std::cerr << "07_cohesive_sample: " << lacking << "; --help lists the options\n";
    std::exit(2);
  }
  return o;
}
