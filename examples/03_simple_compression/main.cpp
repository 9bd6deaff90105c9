// SPDX-License-Identifier: BSD-3-Clause
// Simple compression of a wet cylindrical sample: the paper's section 4 from deposition to the stress-strain curve.
#include "options.hpp"
#include "run.hpp"

#include <pendular/io/progress.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace {

constexpr const char* checkpoint_name = "checkpoint.bin";

restart read_checkpoint(const options& o) {
  if (!o.resume) return {};
  restart from(std::in_place, o.output / checkpoint_name);
  if (const auto label = from->get<std::string>("scene.label"); label != o.physics()) {
    throw std::runtime_error("the checkpoint in " + o.output.string() + " was written with other options (" + label +
                             "): resume with the same ones");
  }
  return from;
}

void run(const options& o, const restart& from, const pendular::scene::monitor& watch) {
  using namespace pendular::friction;
  constexpr double viscosity = 1.0, stiffness = 800.0, coefficient = 0.4;  // N s/m, N/m
  if (o.friction == "viscous-coulomb") return run_test(o, viscous_coulomb{viscosity, coefficient}, from, watch);
  if (o.friction == "viscous-coulomb-explicit") {
    return run_test(o, viscous_coulomb_explicit{viscosity, coefficient}, from, watch);
  }
  run_test(o, coulomb_spring{stiffness, coefficient}, from, watch);
}

void run_job(const options& o) {
#ifdef _OPENMP
  if (o.threads > 0) omp_set_num_threads(o.threads);
#endif
  const restart from = read_checkpoint(o);
  std::filesystem::create_directories(o.output);
  std::unique_ptr<pendular::io::progress> bar;
  std::string shown;
  pendular::scene::monitor watch;
  watch.checkpoint = o.output / checkpoint_name;
  watch.checkpoint_interval = o.checkpoint_interval;
  watch.label = o.physics();
  watch.progress = [&](const std::string& stage, std::int64_t done, std::int64_t total, const std::string& news) {
    if (!bar) {
      bar = std::make_unique<pendular::io::progress>(stage, static_cast<double>(total), static_cast<double>(done));
    } else if (stage != shown) {
      bar->begin(stage, static_cast<double>(total), static_cast<double>(done));
    }
    shown = stage;
    bar->update(static_cast<double>(done), news);
    if (done == total) bar->finish(news);
  };
  run(o, from, watch);
}

}  // namespace

int main(int argc, char** argv) {
  const options o = read_options(argc, argv);
  try {
    run_job(o);
  } catch (const std::exception& error) {
    std::cerr << "\n03_simple_compression: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
