// SPDX-License-Identifier: BSD-3-Clause
// The figures and tables of the paper's tests and of the convergence study, from the folders their jobs have left.
#include "choices.hpp"
#include "cohesion.hpp"
#include "companion.hpp"
#include "compression.hpp"
#include "convergence.hpp"
#include "shear.hpp"

#include "../common/markdown.hpp"

#include <pendular/io/atomic_file.hpp>

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using tables = std::vector<std::pair<std::string, std::string>>;  // with the markers in the page

using parts = std::vector<std::pair<std::string, std::function<std::string()>>>;

parts of_paper(const fs::path& folder, const fs::path& figures) {
  namespace shear = paper::shear;
  namespace compression = paper::compression;
  return {{"fig. 5", [=] { return shear::stress_curves(folder, figures); }},
          {"fig. 6", [=] { return shear::yield_loci(folder, figures); }},
          {"fig. 7", [=] { return shear::bonds(folder, figures); }},
          {"grain size", [=] { return shear::grain_size(folder); }},
          {"choices", [=] { return shear::choices(folder, figures); }},
          {"speeds", [=] { return shear::speeds(folder); }},
          {"settings", [=] { return shear::settings(folder); }},
          {"wet pairs in shear", [=] { return shear::wet_pairs(folder); }},
          {"protocols in shear", [=] { return shear::protocols(folder); }},
          {"fig. 10", [=] { return compression::stress_curves(folder, figures); }},
          {"fig. 11", [=] { return compression::still_zone(folder, figures); }},
          {"fig. 12", [=] { return compression::strengths(folder, figures); }},
          {"relaxation", [=] { return compression::relaxation(folder); }},
          {"settlement", [=] { return compression::settlement(folder, figures); }},
          {"wet pairs in compression", [=] { return compression::wet_pairs(folder); }}};
}

parts of_convergence(const fs::path& folder, const fs::path& figures) {
  namespace convergence = paper::convergence;
  parts all;
  for (const std::string test : {"shear", "compression"}) {
    all.emplace_back(test, [=] {
      const auto studies = convergence::read(folder, test);
      convergence::draw(studies, test, figures / ("convergence_" + test + ".png"));
      return convergence::table_of(studies, test);
    });
  }
  all.emplace_back("laws", [=] { return convergence::table_of_laws(folder); });
  all.emplace_back("rates", [=] {
    const auto rates = convergence::read_rates(folder);
    convergence::draw(rates, figures / "rates.png");
    return convergence::table_of(rates);
  });
  return all;
}

parts of(const std::string& what, const fs::path& folder, const fs::path& figures) {
  if (what == "paper") return of_paper(folder, figures);
  if (what == "convergence") return of_convergence(folder, figures);
  return {{"companion", [=] { return paper::companion::table_of_samples(folder); }}};
}

/// Clears `complete` where a part is left out because its jobs have not ended.
tables made(const parts& all, bool& complete) {
  tables found;
  for (const auto& [name, part] : all) {
    try {
      found.emplace_back(name, part());
    } catch (const std::exception& error) {
      std::cerr << "06_paper: " << name << " is left out: " << error.what() << '\n';
      complete = false;
    }
  }
  return found;
}

void put(const tables& found, const fs::path& folder, const fs::path& page) {
  std::string all;
  for (const auto& [name, text] : found) {
    all += "## " + name + "\n\n" + text + "\n";
    if (!page.empty()) examples::markdown::replace(page, name, text);
  }
  pendular::io::atomic_file file(folder / "tables.md");
  file.write(all);
  file.commit();
  std::cout << all << "Figures and tables.md are in " << folder.string() << '\n';
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Figures and tables from the jobs of the targets paper_jobs, convergence_jobs and companion_jobs.");
  std::string what;
  fs::path folder, page;
  app.add_option("what", what)->required()->check(CLI::IsMember({"paper", "convergence", "companion"}));
  app.add_option("folder", folder, "of the jobs")->required()->check(CLI::ExistingDirectory);
  app.add_option("--page", page, "with markers, to put the tables into")->check(CLI::ExistingFile);
  CLI11_PARSE(app, count, arguments);
  try {
    const fs::path figures = folder / "figures";
    fs::create_directories(figures);
    bool complete = true;
    put(made(of(what, folder, figures), complete), folder, page);
    return complete ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << "06_paper: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
