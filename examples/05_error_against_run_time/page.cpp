// SPDX-License-Identifier: BSD-3-Clause
#include "page.hpp"

#include <cmath>
#include <cstdio>

namespace page {
namespace {

/// Two digits, which another compiler finds again.
std::string two_digits(double x) {
  if (std::isnan(x)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", x);
  return text;
}

std::string nanoseconds(double x) {
  char text[32];
  std::snprintf(text, sizeof text, x < 10 ? "%.1f" : "%.0f", x);
  return text;
}

std::string row(const std::string& law, const std::vector<std::string>& cells) {
  std::string line = "| `" + law + "` |";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

}  // namespace

std::string errors(const std::vector<misfit::summary>& laws, const std::vector<misfit::rupture_summary>& ruptures) {
  std::string text =
      "| capillary law | at contact | to 0.8 D_r | to D_r | to D_r, median | RMS, median | work, median | to "
      "D_r, usual bridges | to D_r, where valid |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& l : laws) {
    text += row(l.law, {two_digits(l.contact), two_digits(l.inner), two_digits(l.whole), two_digits(l.whole_median),
                        two_digits(l.root_mean_median), two_digits(l.work_median), two_digits(l.usual),
                        two_digits(l.where_valid)});
  }
  text += "\n| rupture law | worst | median | worst, usual bridges |\n|---|---|---|---|\n";
  for (const auto& l : ruptures) text += row(l.law, {two_digits(l.worst), two_digits(l.median), two_digits(l.usual)});
  return text;
}

std::string times(const std::vector<cost::of_law>& laws) {
  double unit = 1;
  for (const auto& l : laws) unit = l.law == "richefeu" ? l.in_lanes : unit;
  std::string text = "| capillary law | double | float | lanes of double | lanes of float | preparation | lanes, over "
                     "`richefeu` |\n|---|---|---|---|---|---|---|\n";
  for (const auto& l : laws) {
    text += row(l.law, {nanoseconds(l.in_double), nanoseconds(l.in_float), nanoseconds(l.in_lanes),
                        nanoseconds(l.in_float_lanes), nanoseconds(l.preparation), nanoseconds(l.in_lanes / unit)});
  }
  return text;
}

}  // namespace page
