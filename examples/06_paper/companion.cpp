// SPDX-License-Identifier: BSD-3-Clause
#include "companion.hpp"

#include "../common/markdown.hpp"
#include "measured.hpp"
#include "run.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace paper::companion {

namespace {

using examples::markdown::number;

/// A number of a sample, and what the paper prints for it.
struct column {
  const char* name;
  const char* format;
  const char* printed;
  std::function<double(const run&)> value;
};

std::function<double(const run&)> of(const char* part, const char* name) {
  return [=](const run& r) { return r.number(part, name); };
}
std::function<double(const run&)> decay(const char* side) {
  return [=](const run& r) { return r.number("forces", side, "alpha"); };
}

std::vector<column> columns() {
  return {{"solid fraction, bulk", "%.3f", "", of("end", "solid_fraction_bulk")},
          {"neighbours that press or pull", "%.2f", "6.1", of("neighbours", "all_per_grain")},
          {"press", "%.2f", "2.97", of("neighbours", "compressive_per_grain")},
          {"pull", "%.2f", "3.13", of("neighbours", "tensile_per_grain")},
          {"the same in the bulk, all", "%.2f", "", of("neighbours_in_the_bulk", "all_per_grain")},
          {"bridges across gaps", "%.2f", "", of("end", "bridges_across_gaps_per_grain")},
          {"largest force over f_0", "%.1f", "2", of("forces", "largest_over_f0")},
          {"decay of compression", "%.2f", "4", decay("compressive")},
          {"of tension", "%.2f", "4", decay("tensile")},
          {"grains that nothing presses", "%.2f", "0.08", of("neighbours", "rho_compressive_0")},
          {"that nothing pulls", "%.2f", "0.08", of("neighbours", "rho_tensile_0")},
          {"with as many of both", "%.3f", "0.125", of("neighbours", "share_with_as_many_of_both")},
          {"unbalanced force ratio", "%.0e", "", of("rest", "unbalanced_force_ratio")}};
}

/// As their folders are named, from the driest to the wettest.
std::vector<std::string> samples() {
  std::vector<std::string> names;
  for (const std::string packing : {"dense", "loose"}) {
    for (const char* way : {"touching-w0.007", "eligible-w0.0001", "eligible-w0.0003", "eligible-w0.001",
                            "eligible-w0.007", "eligible-w0.02"}) {
      names.push_back(packing + "-" + way);
    }
  }
  return names;
}

}  // namespace

std::string table_of_samples(const std::filesystem::path& folder) {
  std::vector<std::string> names{"sample"}, printed{"companion paper"};
  const std::vector<column> all = columns();
  for (const column& c : all) names.push_back(c.name), printed.push_back(c.printed);
  examples::markdown::table t(names);
  t.add(printed);
  bool any = false;
  const auto found = cases(folder);
  for (const std::string& name : samples()) {
    const auto at = std::find_if(found.begin(), found.end(), [&](const auto& c) { return c.first == name; });
    if (at == found.end() || at->second.size() < 3) continue;
    const seeds& s = at->second;
    any = true;
    std::vector<std::string> cells{name};
    for (const column& c : all) {
      const measured m = mean_of(each(s, c.value));
      const bool exponent = std::string(c.format).find('e') != std::string::npos;
      cells.push_back(exponent ? number(c.format, m.mean) : number(c.format, m.mean, m.error));
    }
    t.add(cells);
  }
  if (!any) throw std::runtime_error("no sample has three seeds in " + folder.string());
  return t.text();
}

}  // namespace paper::companion
