// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace {

const CLI::Validator positive(
    [](std::string& text) -> std::string {
      try {
        std::size_t used = 0;
        const double value = std::stod(text, &used);
        if (used == text.size() && value > 0 && value < 1e300) return {};
      } catch (const std::exception&) {  // not a number
      }
      return "is " + text + ", but must be a number above 0";
    },
    "NUMBER > 0", "positive");

void describe(CLI::App& app, options& o) {
  app.add_option("output,--output", o.output, "folder for results and checkpoint")->capture_default_str();
  app.add_option("--water-content", o.water_content, "w, mass of water over mass of grains")
      ->check(CLI::Range(0.0, 0.5))
      ->capture_default_str();
  app.add_option("--protocol", o.protocol, "redistribution of liquid: P1, P0, P2, P3 of the paper, or none")
      ->check(CLI::IsMember({"homogeneous", "neighbours", "grain-films", "gravity", "none"}))
      ->capture_default_str();
  app.add_option("--law", o.law, "capillary law")
      ->check(CLI::IsMember({"richefeu", "richefeu-harmonic", "laplace-young"}))
      ->capture_default_str();
  app.add_option("--friction", o.friction, "friction law; the paper has viscous-coulomb")
      ->check(CLI::IsMember({"coulomb-spring", "viscous-coulomb", "viscous-coulomb-explicit"}))
      ->capture_default_str();
  app.add_option("--thinning", o.thinning, "keep one bond in so many at the same water content")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  app.add_option("--kappa", o.surface_tension_force, "2 pi gamma_s cos(theta), N/m")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--wall-speed", o.wall_speed, "of the upper wall, m/s")->check(positive)->capture_default_str();
  app.add_option("--duration", o.duration, "of the compression, s")->check(positive)->capture_default_str();
  app.add_option("--time-step", o.time_step, "of the test, s; the paper has 1e-6, with --mass-scaling 1")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--mass-scaling", o.mass_scaling, "factor on the inertia of the grains, not on their weight")
      ->check(positive)
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
  app.add_option("--seed", o.seed, "of all random choices")->capture_default_str();
  app.add_option("--threads", o.threads, "0: all of the machine; results do not depend on it")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--checkpoint-interval", o.checkpoint_interval, "steps")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40))
      ->capture_default_str();
  app.add_option("--snapshots", o.snapshots, "number of states written for ParaView")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_flag_callback(
      "--paper", [&o] { o.friction = "viscous-coulomb", o.time_step = 1e-6, o.mass_scaling = 1; },
      "as the paper and its companion have it: Eq. 12, 1e-6 s, mass as it is");
  app.add_flag("--resume", o.resume, "go on from the checkpoint in the output folder");
  app.add_flag("--force", o.force, "run although the scene breaks a limit of stability");
  app.add_flag("!--no-pictures", o.pictures, "leave out plots and pictures");
}

}  // namespace

std::string options::physics() const {
  std::ostringstream text;
  text.precision(17);
  text << "water-content " << water_content << " protocol " << protocol << " law " << law << " friction " << friction
       << " thinning " << thinning << " kappa " << surface_tension_force << " wall-speed " << wall_speed << " duration "
       << duration << " time-step " << time_step << " mass-scaling " << mass_scaling << " preparation-friction "
       << preparation_friction << " packing " << packing.string() << " grains " << grains << " seed " << seed
       << " checkpoint-interval " << checkpoint_interval;
  return text.str();
}

options read_options(int argc, char** argv) {
  options o;
  CLI::App app("Simple compression of a wet granular sample (Richefeu et al. 2007, section 4).");
  describe(app, o);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    std::exit(EXIT_SUCCESS);
  } catch (const CLI::ParseError& error) {
    std::cerr << "03_simple_compression: " << error.what() << " (--help lists the options)\n";
    std::exit(2);
  }
  return o;
}
