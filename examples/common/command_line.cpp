// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>

namespace examples {

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

void describe(CLI::App& app, job_options& o) {
  app.add_option("output,--output", o.output, "folder for results and checkpoint")->capture_default_str();
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
  app.add_flag("--resume", o.resume, "go on from the checkpoint in the output folder");
  app.add_flag("--continue", o.go_on, "the same if there is one, from the start if not");
  app.add_flag("--packing-only", o.packing_only, "stop when packing.bin is written");
  app.add_flag("--force", o.force, "run although the scene breaks a limit of stability");
  app.add_flag("!--no-pictures", o.pictures, "leave out plots and pictures");
}

namespace {

void describe_liquid(CLI::App& app, wet_options& o) {
  app.add_option("--water-content", o.water_content, "w, mass of water over mass of grains")
      ->check(CLI::Range(0.0, 0.5))
      ->capture_default_str();
  app.add_option("--protocol", o.protocol, "redistribution of liquid: P1, P0, P2, P3 of the paper, or none")
      ->check(CLI::IsMember({"homogeneous", "neighbours", "grain-films", "gravity", "none"}))
      ->capture_default_str();
  app.add_option("--law", o.law, "capillary law; others than the paper's need the usual protocol and friction")
      ->check(CLI::IsMember({"richefeu", "richefeu-harmonic", "willett", "laplace-young"}))
      ->capture_default_str();
  app.add_option("--thinning", o.thinning, "keep one bond in so many at the same water content")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  app.add_option("--widest-gap", o.widest_gap, "across which a distribution wets pairs, m; 0: touching pairs only")
      ->check(CLI::Range(0.0, std::numeric_limits<double>::infinity()))
      ->capture_default_str();
  app.add_option("--film-thickness", o.film_thickness, "of the film that stays on the grains before a bridge exists, m")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--kappa", o.surface_tension_force, "2 pi gamma_s cos(theta), N/m")
      ->check(positive)
      ->capture_default_str();
}

void describe_contacts(CLI::App& app, wet_options& o) {
  app.add_option("--friction", o.friction, "friction law; the paper has viscous-coulomb")
      ->check(CLI::IsMember({"coulomb-spring", "viscous-coulomb", "viscous-coulomb-explicit"}))
      ->capture_default_str();
  app.add_option("--tangential-viscosity", o.tangential_viscosity, "gamma_t of viscous-coulomb, N s/m")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--stiffness", o.stiffness, "k_n, N/m; a tangential spring has 0.8 of it")
      ->check(positive)
      ->capture_default_str();
}

void describe_steps(CLI::App& app, wet_options& o) {
  app.add_option("--time-step", o.time_step, "of the test, s; the paper has 1e-6, with --mass-scaling 1")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--mass-scaling", o.mass_scaling, "factor on the inertia of the grains, not on their weight")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--skin", o.skin, "of the neighbour list over the smallest radius; results do not depend on it")
      ->check(CLI::Range(0.001, 9.9));
  app.add_flag_callback(
         "--paper", [&o] { o.take_from_paper(); },
         "as the paper and its companion have it: Eq. 12, 1e-6 s, mass as it is; what is said besides counts")
      ->trigger_on_parse();
}

/// What is not built is refused.
void expect_built(const wet_options& o, const std::string& usual) {
  if (o.law != "richefeu" && (o.friction != "coulomb-spring" || o.protocol != usual)) {
    throw CLI::ValidationError("--law " + o.law, "is built with --friction coulomb-spring and --protocol " + usual +
                                                     " only, not with " + o.friction + " and " + o.protocol);
  }
  if (o.friction == "viscous-coulomb-explicit" && o.protocol != usual) {
    throw CLI::ValidationError("--friction " + o.friction,
                               "is built with --protocol " + usual + " only, not with " + o.protocol);
  }
}

}  // namespace

void describe(CLI::App& app, wet_options& o) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  describe_liquid(app, o);
  describe_contacts(app, o);
  describe_steps(app, o);
  app.callback([&o, usual = o.protocol] { expect_built(o, usual); });
}

void parse(CLI::App& app, const std::string& program, int count, char** arguments) {
  try {
    app.parse(count, arguments);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    std::exit(EXIT_SUCCESS);
  } catch (const CLI::ParseError& error) {
    std::cerr << program << ": " << error.what() << " (--help lists the options)\n";
    std::exit(2);
  }
}

}  // namespace examples
