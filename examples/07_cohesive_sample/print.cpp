// SPDX-License-Identifier: BSD-3-Clause
#include "figures.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <string>

namespace {

using json = nlohmann::ordered_json;

class lines {
 public:
  explicit lines(const json& summary) : summary_(summary) {}

  /// `where` is a path in the summary: "/forces/largest_over_f0".
  void add(const char* what, const char* where, const char* paper) const {
    std::printf("%-46s %12.4g   %s\n", what, number(where), paper);
  }
  /// A pair of numbers.
  void add_class(const char* what, const char* where, const char* paper) const {
    const std::string at = where;
    std::printf("%-46s   (%3.0f, %3.0f)   %s\n", what, number(at + "/0"), number(at + "/1"), paper);
  }
  void add_neighbours(const char* what, const char* where, const char* paper) const {
    const std::string at = std::string("/pressures/classes/") + where;
    std::printf("%-46s %5.2f, %5.2f   %s\n", what, number(at + "/compressive_per_grain"),
                number(at + "/tensile_per_grain"), paper);
  }

 private:
  double number(const std::string& where) const {
    const json::json_pointer at(where);
    return summary_.contains(at) && summary_[at].is_number() ? summary_[at].get<double>() : std::nan("");
  }

  const json& summary_;
};

void print_neighbours(const lines& l) {
  l.add("neighbours with a force, per grain", "/neighbours/all_per_grain", "6.1");
  l.add("  that press", "/neighbours/compressive_per_grain", "2.97; under 100 Pa 4.85");
  l.add("  that pull", "/neighbours/tensile_per_grain", "3.13; under 100 Pa 0.85");
  l.add("  in the bulk", "/neighbours_in_the_bulk/all_per_grain", "");
  l.add("bridges per grain", "/end/bridges_per_grain", "");
  l.add("  across a gap", "/end/bridges_across_gaps_per_grain", "");
  l.add("grains that nothing presses, rho+(0)", "/neighbours/rho_compressive_0", "0.08");
  l.add("grains that nothing pulls, rho-(0)", "/neighbours/rho_tensile_0", "0.08");
  l.add("grains with as many of both", "/neighbours/share_with_as_many_of_both", "0.125");
  l.add_class("most common class (k+, k-)", "/neighbours/peak_of_rho", "(2, 2)");
}

void print_forces(const lines& l) {
  l.add("largest force over f0", "/forces/largest_over_f0", "2");
  l.add("decay of the compressive forces, times f0", "/forces/compressive/alpha", "4");
  l.add("  standard error", "/forces/compressive/error", "");
  l.add("decay of the tensile forces, times f0", "/forces/tensile/alpha", "4");
  l.add("  standard error", "/forces/tensile/error", "");
}

void print_pressures(const lines& l) {
  l.add("mean pressure of the grains over p0", "/pressures/mean_over_p0", "0");
  l.add_class("largest partial pressure at (k+, k-)", "/pressures/largest_partial_at", "(4, 0)");
  l.add_class("least partial pressure at (k+, k-)", "/pressures/least_partial_at", "(0, 4)");
  l.add_neighbours("z+, z- of the grains below -p0", "below_minus_p0", "0.5, 5");
  l.add_neighbours("z+, z- of the grains within p0 / 4", "within_a_quarter_of_p0", "3, 3 at 0");
  l.add_neighbours("z+, z- of the grains above p0", "above_p0", "4, 0.5");
}

}  // namespace

void print_beside_the_paper(const json& summary) {
  const lines l(summary);
  std::printf("\n%-46s %12s   %s\n", "", "here", "companion paper");
  l.add("solid fraction in the bulk", "/end/solid_fraction_bulk", "");
  l.add("unbalanced force ratio of the dry packing", "/rest/packing_unbalanced_force_ratio", "");
  l.add("unbalanced force ratio", "/rest/unbalanced_force_ratio", "");
  l.add("time until rest, s", "/rest/time_s", "");
  l.add("stress on the walls, Pa", "/rest/wall_stress_Pa", "0 or 100");
  print_neighbours(l);
  print_forces(l);
  print_pressures(l);
}
