// SPDX-License-Identifier: BSD-3-Clause
#include "job.hpp"

#include "folder_lock.hpp"

#include <pendular/io/progress.hpp>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace examples {

namespace {

constexpr const char* checkpoint_name = "checkpoint.bin";

restart read_checkpoint(const job_options& o, const std::string& physics) {
  const bool begun = std::filesystem::exists(o.output / checkpoint_name);
  if (!o.resume && !(o.go_on && begun)) return {};
  restart from(std::in_place, o.output / checkpoint_name);
  if (const auto label = from->get<std::string>("scene.label"); label != physics) {
    throw std::runtime_error("the checkpoint in " + o.output.string() + " was written with other options (" + label +
                             "): resume with the same ones, or remove it");
  }
  return from;
}

/// One bar for all stages.
class stage_bar {
 public:
  void operator()(const std::string& stage, std::int64_t done, std::int64_t total, const std::string& news) {
    if (!bar_) {
      bar_ = std::make_unique<pendular::io::progress>(stage, static_cast<double>(total), static_cast<double>(done));
    } else if (stage != shown_) {
      bar_->begin(stage, static_cast<double>(total), static_cast<double>(done));
    }
    shown_ = stage;
    bar_->update(static_cast<double>(done), news);
    if (done == total) bar_->finish(news);
  }

 private:
  std::unique_ptr<pendular::io::progress> bar_;
  std::string shown_;
};

}  // namespace

std::string label_of(const std::filesystem::path& file) {
  if (file.empty()) return "none";
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (std::istreambuf_iterator<char> c(in), end; c != end; ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 1099511628211U;
  }
  return std::to_string(hash);
}

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

namespace {
const double start = seconds();
}
double seconds_since_start() { return seconds() - start; }

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

int thread_count() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

int run_job(const std::string& program, const job_options& o, const std::string& physics,
            const std::function<void(const restart&, const pendular::scene::monitor&)>& work) {
  try {
#ifdef _OPENMP
    if (o.threads > 0) omp_set_num_threads(o.threads);
#endif
    std::filesystem::create_directories(o.output);
    const folder_lock alone(o.output);
    const restart from = read_checkpoint(o, physics);
    stage_bar bar;
    pendular::scene::monitor watch;
    watch.checkpoint = o.output / checkpoint_name;
    watch.checkpoint_interval = o.checkpoint_interval;
    watch.label = physics;
    watch.progress = std::ref(bar);
    work(from, watch);
  } catch (const std::exception& error) {
    std::cerr << '\n' << program << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace examples
