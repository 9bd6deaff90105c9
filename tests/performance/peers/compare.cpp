// SPDX-License-Identifier: BSD-3-Clause
// The same packing under this library, LAMMPS and YADE, in turns, each on one core: time per grain and step as a table
// and over the number of grains as a plot.
#include "lammps.hpp"
#include "ours.hpp"
#include "report.hpp"
#include "time_over_size.hpp"
#include "yade.hpp"

#include <cstdlib>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace peers;

namespace {

struct size_of_run {
  std::size_t grains;
  int warmup, steps, rounds, tries;  // tries: of every skin; none: those of the size before
};
constexpr size_of_run sizes[] = {{1000, 150, 600, 9, 2}, {8000, 150, 600, 7, 2}, {64000, 20, 80, 3, 0}};
constexpr std::size_t size_of_table = 8000;  // grains

/// Those of the neighbour lists of the peers that are installed, m.
struct best_skins {
  std::optional<double> lammps, yade;
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
  all.push_back({"pendular", "dry", [&t] { return ours(t, scenes::dry); }});
  if (skins.lammps) all.push_back({"LAMMPS", "dry", [&t, skin = *skins.lammps] { return lammps::dry(t, skin); }});
  all.push_back({"pendular", "wet", [&t] { return ours(t, scenes::wet); }});
  if (skins.yade) all.push_back({"YADE", "wet", [&t, skin = *skins.yade] { return yade::wet(t, skin); }});
  if (all_scenes) {
    all.push_back({"pendular", "wet, YADE's laws", [&t] { return ours(t, scenes::wet_willett); }});
    all.push_back({"pendular", "smooth", [&t] { return ours(t, scenes::smooth); }});
  }
  return all;
}

const contender* found(const std::vector<contender>& all, const std::string& code, const std::string& scene) {
  for (const contender& c : all) {
    if (c.code == code && c.scene == scene) return &c;
  }
  return nullptr;
}

std::string ratios(const std::vector<contender>& all) {
  const auto* wet = found(all, "pendular", "wet");
  const auto* lammps = found(all, "LAMMPS", "dry");
  const auto* yade = found(all, "YADE", "wet");
  if (!lammps && !yade) return "";
  std::string text = "| time over time | median of the rounds | smallest to largest |\n|---|---|---|\n";
  if (yade) text += report::ratio_row(*yade, *wet);
  const auto* same_laws = found(all, "pendular", "wet, YADE's laws");
  if (yade && same_laws) text += report::ratio_row(*yade, *same_laws);
  if (lammps) text += report::ratio_row(*lammps, *found(all, "pendular", "dry"));
  if (lammps) text += report::ratio_row(*wet, *lammps);
  return text;
}

void compare(const std::filesystem::path& folder, const std::string& page) {
  const bool with_lammps = is_there("LAMMPS", lammps::program), with_yade = is_there("YADE", yade::program);
  const auto block = packing::block("packing_8000.bin");
  best_skins skins;
  time_over_size plot;
  for (const size_of_run& size : sizes) {
    const task t = task_of(packing::of_size(block, size.grains), size.warmup, size.steps);
    std::printf("%zu grains\n", size.grains);
    const auto with = [&t](auto run) { return [&t, run](double skin) { return run(t, skin); }; };
    if (with_lammps && size.tries > 0) skins.lammps = best_skin("LAMMPS", lammps::skins, size.tries, with(lammps::dry));
    if (with_yade && size.tries > 0) skins.yade = best_skin("YADE", yade::skins, size.tries, with(yade::wet));
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
#ifdef _OPENMP
  omp_set_num_threads(1);
#endif
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
