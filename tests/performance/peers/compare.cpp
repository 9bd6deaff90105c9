// SPDX-License-Identifier: BSD-3-Clause
// The same packing under this library, in three builds, LAMMPS, LIGGGHTS and YADE, in turns, each on one core: time per
// grain and step as a table and over the number of grains as a plot.
#include "builds.hpp"
#include "lammps.hpp"
#include "liggghts.hpp"
#include "report.hpp"
#include "time_over_size.hpp"
#include "yade.hpp"

#include <cstdlib>
#include <exception>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

using namespace peers;

namespace {

measurement liggghts_wet(const task& t, double skin) { return liggghts::run(t, skin, true); }
measurement liggghts_dry(const task& t, double skin) { return liggghts::run(t, skin, false); }

struct size_of_run {
  std::size_t grains;
  int warmup, steps, rounds, tries;  // tries: of every skin; none: those of the size before
};
constexpr size_of_run sizes[] = {{1000, 150, 600, 9, 2}, {8000, 150, 600, 7, 2}, {64000, 20, 80, 3, 0}};
constexpr std::size_t size_of_table = 8000;  // grains

/// Those of the neighbour lists of the peers that are installed, m.
struct best_skins {
  std::optional<double> lammps, yade, liggghts_wet, liggghts_dry;
};

/// The one with which a peer is fastest in the very steps that are measured.
template <class Skins, class Run>
double best_skin(const char* name, const Skins& skins, int tries, const Run& run) {
  std::pair<double, double> best{std::numeric_limits<double>::infinity(), 0};
  std::string times;
  for (const double skin : skins) {
    double time = std::numeric_limits<double>::infinity();
    for (int k = 0; k < tries; ++k) time = std::min(time, run(skin).time);
    best = std::min(best, {time, skin});
    times += report::formatted(" %g m: %.0f,", skin, time);
  }
  std::printf("%s, ns per grain and step with a skin of%s taken: %g m\n", name, times.c_str(), best.second);
  return best.second;
}

bool is_there(const char* name, const char* program) {
  const bool there = is_installed(program);
  if (!there) std::printf("%s is left out, because its program '%s' is not installed.\n", name, program);
  return there;
}

/// Neighbours in the list are compared with each other.
std::vector<contender> contenders(const task& t, const best_skins& skins, bool all_scenes) {
  std::vector<contender> all;
  const auto add_ours = [&](const char* scene, const char* name) {
    for (const builds::build& b : builds::all) {
      if (builds::runs_here(b)) all.push_back({b.name, name, [&t, b, scene] { return builds::run(b, t, scene); }});
    }
  };
  const auto add = [&](const char* code, const char* scene, std::optional<double> skin, auto run) {
    if (skin) all.push_back({code, scene, [&t, run, s = *skin] { return run(t, s); }});
  };
  add_ours("dry", "dry");
  add("LAMMPS", "dry", skins.lammps, lammps::dry);
  add("LIGGGHTS", "dry", skins.liggghts_dry, liggghts_dry);
  add_ours("wet", "wet");
  add("LIGGGHTS", "wet", skins.liggghts_wet, liggghts_wet);
  add("YADE", "wet", skins.yade, yade::wet);
  if (all_scenes) add_ours("wet_willett", "wet, YADE's laws"), add_ours("smooth", "smooth");
  return all;
}

const contender* found(const std::vector<contender>& all, const std::string& code, const std::string& scene) {
  for (const contender& c : all) {
    if (c.code == code && c.scene == scene) return &c;
  }
  return nullptr;
}

/// Every peer over every build in the same scene, and the builds over the fastest.
std::string ratios(const std::vector<contender>& all) {
  std::string text = "| time over time | median of the rounds | smallest to largest |\n|---|---|---|\n";
  for (const contender& c : all) {
    const bool ours = c.code.starts_with("pendular");
    for (const builds::build& b : builds::all) {
      const auto* other = found(all, b.name, c.scene);
      if (!other || other == &c || (ours && &b != &builds::all[std::size(builds::all) - 1])) continue;
      text += report::ratio_row(c, *other);
    }
  }
  return text;
}

void compare(const std::filesystem::path& folder, const std::string& page) {
  const bool with_lammps = is_there("LAMMPS", lammps::program), with_yade = is_there("YADE", yade::program);
  const bool with_liggghts = is_there("LIGGGHTS", liggghts::program);
  const auto block = packing::block("packing_8000.bin");
  best_skins skins;
  time_over_size plot;
  for (const size_of_run& size : sizes) {
    const task t = task_of(packing::of_size(block, size.grains), size.warmup, size.steps);
    std::printf("%zu grains\n", size.grains);
    const auto try_skins = [&](const char* name, bool there, const auto& some, auto run, std::optional<double>& best) {
      if (!there || size.tries == 0) return;
      best = best_skin(name, some, size.tries, [&](double skin) { return run(t, skin); });
    };
    try_skins("LAMMPS", with_lammps, lammps::skins, lammps::dry, skins.lammps);
    try_skins("LIGGGHTS, dry", with_liggghts, liggghts::skins, liggghts_dry, skins.liggghts_dry);
    try_skins("LIGGGHTS, wet", with_liggghts, liggghts::skins, liggghts_wet, skins.liggghts_wet);
    try_skins("YADE", with_yade, yade::skins, yade::wet, skins.yade);
    auto all = contenders(t, skins, size.grains == size_of_table);
    run_in_turns(all, size.rounds);
    plot.add(t.grains(), all);
    const std::string text = report::table(all) + "\n" + ratios(all);
    std::printf("\n%s\n", text.c_str());
    std::fflush(stdout);
    if (size.grains == size_of_table && !page.empty()) report::replace(page, "against other codes", text);
  }
  plot.draw(folder);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const std::filesystem::path folder = count > 1 ? arguments[1] : "peers";
    compare(folder, count > 2 ? arguments[2] : "");
    std::printf("Plot in %s\n", folder.string().c_str());
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "performance_peers: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
