// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "../common/command_line.hpp"
#include "../common/departures.hpp"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

options::options() {
  output = "direct_shear";
  water_content = 0.01;
  protocol = "grain-films";  // section 3.2
  friction = "viscous-coulomb";
  stiffness = 2500;  // 1000 N/m would let grains of 2 mm overlap by more than a thousandth
  time_step = 3.5e-6;
  mass_scaling = 1;
}

double options::cell_radius() const { return 23e-3 * scale * std::cbrt(static_cast<double>(grains) / 7307.0); }

pendular::scene::grading options::grain_sizes() const {
  pendular::scene::grading sizes = pendular::scene::shear_grading();
  for (auto& share : sizes) share.diameter *= scale;
  return sizes;
}

namespace {

void describe(CLI::App& app, options& o) {
  app.add_option("--normal-stress", o.normal_stress, "of the lid, Pa")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--shear-speed", o.shear_speed, "of the upper half, m/s")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--displacement", o.displacement, "of the upper half, m")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--preparation-friction", o.preparation_friction,
                 "between grains while they are deposited; 0 is densest")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  app.add_option("--solid-fraction", o.solid_fraction,
                 "over the cell, at which friction comes, if the sample gets so dense without")
      ->check(CLI::Range(0.3, 0.73))
      ->capture_default_str();
  app.add_option("--wall-friction", o.wall_friction, "of both halves; what is not 0 adds to the normal stress")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  app.add_option("--plate-friction", o.plate_friction, "of the floor, and of the lid, which moves with the upper half")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  app.add_option("--scale", o.scale, "of grains and cell over the paper's")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--residual-from", o.residual_from, "the residual stress is the mean beyond so many mean diameters")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--packing", o.packing, "start from packing.bin of an earlier job of as many grains")
      ->check(CLI::ExistingFile);
  app.add_option("--grains", o.grains, "number of grains; fewer than 7307 make a smaller cell of the same shape")
      ->check(CLI::Range(std::int64_t{100}, std::int64_t{1000000}))
      ->capture_default_str();
}

}  // namespace

std::string options::physics() const {
  std::ostringstream text;
  text.precision(17);
  text << physics_of(*this) << " normal-stress " << normal_stress << " shear-speed " << shear_speed << " displacement "
       << displacement << " preparation-friction " << preparation_friction << " solid-fraction " << solid_fraction
       << " wall-friction " << wall_friction << " plate-friction " << plate_friction << " scale " << scale
       << " packing " << examples::label_of(packing) << " grains " << grains << " seed " << seed
       << " checkpoint-interval " << checkpoint_interval;
  return text.str();
}

std::vector<std::string> options::departures() const {
  examples::departures list(departures_of(*this));
  const options usual;
  list.add(grains != usual.grains, "grains: ", grains, " in a cell of their size; the paper has 7307 in 46 mm");
  list.add(scale != 1, "scale: grains and cell ", scale, " times the paper's");
  list.add(preparation_friction != 0.4, "preparation: friction ", preparation_friction,
           " between grains while they fall; in the test it is 0.4");
  list.add(solid_fraction != 0.6, "solid fraction: ", solid_fraction,
           " over the cell when friction comes; the paper has 0.6 and does not say of what");
  list.add(true, "cell: split at mid-height of the consolidated sample; the paper has halves of 10 and 15 mm");
  list.add(true, "open in the paper, chosen here: speed ", shear_speed, " m/s, friction of the halves ", wall_friction,
           ", of floor and lid ", plate_friction);
  return list.lines();
}

options read_options(int count, char** arguments) {
  options o;
  CLI::App app("Direct shear of a dry or wet granular sample (Richefeu et al. 2007, section 3.2).");
  examples::describe(app, static_cast<examples::wet_options&>(o));
  describe(app, o);
  examples::describe(app, static_cast<examples::job_options&>(o));
  examples::parse(app, "04_direct_shear", count, arguments);
  const double reach = o.displacement / pendular::scene::mean_diameter(o.grain_sizes());
  if (!o.packing_only && o.residual_from > 0.9 * reach) {
    std::cerr << "04_direct_shear: --residual-from is " << o.residual_from
              << " mean diameters, but must be at most 0.9 of "
              << "--displacement, which is " << reach << "; docs/how-to/run_the_paper.md\n";
    std::exit(2);
  }
  return o;
}
