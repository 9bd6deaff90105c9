// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "../common/command_line.hpp"
#include "../common/departures.hpp"

#include <cmath>
#include <sstream>

double options::cylinder_radius() const { return 12.5e-3 * std::cbrt(static_cast<double>(grains) / 8000.0); }

namespace {

void describe(CLI::App& app, options& o) {
  app.add_option("--wall-speed", o.wall_speed, "of the upper wall, m/s")
      ->check(examples::positive)
      ->capture_default_str();
  app.add_option("--duration", o.duration, "of the compression, s")->check(examples::positive)->capture_default_str();
  app.add_option("--relaxation", o.relaxation, "without the cylinder before the wall moves, s; 0: none")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--preparation-friction", o.preparation_friction,
                 "between grains while the sample is made; 0 is densest")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  app.add_option("--packing", o.packing, "start from packing.bin of an earlier job of as many grains")
      ->check(CLI::ExistingFile);
  app.add_option("--grains", o.grains, "number of grains; fewer than 8000 make a smaller sample of the same shape")
      ->check(CLI::Range(std::int64_t{40}, std::int64_t{1000000}))
      ->capture_default_str();
}

}  // namespace

std::string options::physics() const {
  std::ostringstream text;
  text.precision(17);
  text << physics_of(*this) << " wall-speed " << wall_speed << " duration " << duration << " relaxation " << relaxation
       << " preparation-friction " << preparation_friction << " packing " << examples::label_of(packing) << " grains "
       << grains << " seed " << seed << " checkpoint-interval " << checkpoint_interval;
  return text.str();
}

std::vector<std::string> options::departures() const {
  examples::departures list(departures_of(*this));
  const options usual;
  list.add(grains != usual.grains, "grains: ", grains, " in a smaller cylinder; the paper has 8000 in 25 mm");
  list.add(wall_speed != usual.wall_speed, "wall speed: ", wall_speed, " m/s; the paper has 1 mm/s");
  list.add(duration != usual.duration, "duration: ", duration, " s; the paper has 2 s");
  list.add(relaxation == 0, "relaxation: none before the wall moves");
  list.add(preparation_friction != 0, "preparation: friction ", preparation_friction,
           " between grains; the paper does not say");
  return list.lines();
}

options read_options(int count, char** arguments) {
  options o;
  CLI::App app("Simple compression of a wet granular sample (Richefeu et al. 2007, section 4).");
  examples::describe(app, static_cast<examples::wet_options&>(o));
  describe(app, o);
  examples::describe(app, static_cast<examples::job_options&>(o));
  examples::parse(app, "03_simple_compression", count, arguments);
  return o;
}
