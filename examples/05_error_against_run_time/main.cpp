// SPDX-License-Identifier: BSD-3-Clause
// Every capillary law of the library against Laplace-Young: how far off it is, and what it costs.
#include "cost.hpp"
#include "figures.hpp"
#include "misfit.hpp"
#include "page.hpp"

#include "../common/markdown.hpp"

#include <pendular/io/atomic_file.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  pendular::io::atomic_file file(path);
  file.write(text);
  file.commit();
}

void write_bridges(const std::filesystem::path& file, const std::vector<misfit::of_bridge>& rows) {
  std::ostringstream out;
  out << "law,contact_angle_deg,size_ratio,volume_over_R3,contact,to_0.8_Dr,to_Dr,rms,work_relative,valid\n";
  for (const auto& r : rows) {
    out << r.law << ',' << r.contact_angle << ',' << r.size_ratio << ',' << r.volume << ',' << r.contact << ','
        << r.inner << ',' << r.whole << ',' << r.root_mean << ',' << r.work << ',' << r.valid << '\n';
  }
  write(file, out.str());
}

void write_ruptures(const std::filesystem::path& file, const std::vector<misfit::of_rupture>& rows) {
  std::ostringstream out;
  out << "law,contact_angle_deg,size_ratio,volume_over_R3,relative_error,valid\n";
  for (const auto& r : rows) {
    out << r.law << ',' << r.contact_angle << ',' << r.size_ratio << ',' << r.volume << ',' << r.distance << ','
        << r.valid << '\n';
  }
  write(file, out.str());
}

void write_summary(const std::filesystem::path& file, const std::vector<misfit::summary>& laws,
                   const std::vector<cost::of_law>& times) {
  std::ostringstream out;
  out << "law,contact,to_0.8_Dr,to_Dr,to_Dr_median,rms_median,work_median,to_Dr_usual,to_Dr_valid,double_ns,float_ns,"
         "lanes_ns,float_lanes_ns,prepare_ns\n";
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const auto& l = laws[k];
    const auto& t = times.at(k);
    out << l.law << ',' << l.contact << ',' << l.inner << ',' << l.whole << ',' << l.whole_median << ','
        << l.root_mean_median << ',' << l.work_median << ',' << l.usual << ',' << l.where_valid << ',' << t.in_double
        << ',' << t.in_float << ',' << t.in_lanes << ',' << t.in_float_lanes << ',' << t.preparation << '\n';
  }
  write(file, out.str());
}

/// Whether the errors on the page are those of the laws as they are now; times are not compared.
int check(const std::filesystem::path& file, const std::string& errors) {
  if (examples::markdown::between(file, "errors") == errors) return EXIT_SUCCESS;
  std::fprintf(stderr,
               "the errors on '%s' are not those of the laws as they are now; run 05_error_against_run_time --page "
               "with that file. They should be:\n%s",
               file.string().c_str(), errors.c_str());
  return EXIT_FAILURE;
}

void study(const std::filesystem::path& folder, const std::string& page_file) {
  const misfit::all found = misfit::judge();
  const auto laws = misfit::summarise(found.bridges);
  const auto ruptures = misfit::summarise(found.ruptures);
  const auto times = cost::measure();
  write_summary(folder / "error_against_run_time.csv", laws, times);
  write_bridges(folder / "bridges.csv", found.bridges);
  write_ruptures(folder / "ruptures.csv", found.ruptures);
  const std::string errors = page::errors(laws, ruptures), cost = page::times(times);
  write(folder / "error_against_run_time.md", errors + "\n" + cost);
  std::printf("%s\n%s\nResults in %s\n", errors.c_str(), cost.c_str(), folder.string().c_str());
  figures::pareto(laws, times, folder);
  figures::paper(folder);
  if (page_file.empty()) return;
  examples::markdown::replace(page_file, "errors", errors);
  examples::markdown::replace(page_file, "times", cost);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Scores every capillary and rupture law against the Laplace-Young equation"};
  std::string folder = "error_against_run_time", page_file, checked;
  app.add_option("output,--output", folder, "folder for tables and plots")->capture_default_str();
  app.add_option("--page", page_file, "Markdown page whose tables are written anew")->check(CLI::ExistingFile);
  app.add_option("--check", checked, "Markdown page whose errors are compared, and nothing else")
      ->check(CLI::ExistingFile);
  CLI11_PARSE(app, argc, argv);
  try {
    if (!checked.empty()) {
      const misfit::all found = misfit::judge();
      return check(checked, page::errors(misfit::summarise(found.bridges), misfit::summarise(found.ruptures)));
    }
    study(folder, page_file);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "05_error_against_run_time: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
