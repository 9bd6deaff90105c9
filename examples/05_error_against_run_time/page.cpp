// SPDX-License-Identifier: BSD-3-Clause
#include "page.hpp"

#include "../common/markdown.hpp"

namespace page {
namespace {

using examples::markdown::number;
using examples::markdown::table;

/// Two digits, which another compiler finds again.
std::string two_digits(double x) { return number("%.1e", x); }

std::string nanoseconds(double x) { return number(x < 10 ? "%.1f" : "%.0f", x); }

std::string code(const std::string& law) { return "`" + law + "`"; }

}  // namespace

std::string errors(const std::vector<misfit::summary>& laws, const std::vector<misfit::rupture_summary>& ruptures) {
  table capillary({"capillary law", "at contact", "to 0.8 D_r", "to D_r", "to D_r, median", "RMS, median",
                   "work, median", "to D_r, usual bridges", "to D_r, where valid"});
  for (const auto& l : laws) {
    capillary.add({code(l.law), two_digits(l.contact), two_digits(l.inner), two_digits(l.whole),
                   two_digits(l.whole_median), two_digits(l.root_mean_median), two_digits(l.work_median),
                   two_digits(l.usual), two_digits(l.where_valid)});
  }
  table rupture({"rupture law", "worst", "median", "worst, usual bridges"});
  for (const auto& l : ruptures) {
    rupture.add({code(l.law), two_digits(l.worst), two_digits(l.median), two_digits(l.usual)});
  }
  return capillary.text() + "\n" + rupture.text();
}

std::string times(const std::vector<cost::of_law>& laws) {
  double unit = 1;
  for (const auto& l : laws) unit = l.law == "richefeu" ? l.in_lanes : unit;
  table t({"capillary law", "double", "float", "lanes of double", "lanes of float", "preparation",
           "lanes, over `richefeu`"});
  for (const auto& l : laws) {
    t.add({code(l.law), nanoseconds(l.in_double), nanoseconds(l.in_float), nanoseconds(l.in_lanes),
           nanoseconds(l.in_float_lanes), nanoseconds(l.preparation), nanoseconds(l.in_lanes / unit)});
  }
  return t.text();
}

}  // namespace page
