// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pendular::testing {

/// The properties a law breaks, one sentence each with the first counterexample; empty for a sound law.
using report = std::vector<std::string>;

struct quantity {
  std::string_view name;
  double value;
};

/// Records the first counterexample to a property and ignores the others.
inline void demand(report& broken, bool holds, std::string_view property, std::initializer_list<quantity> example) {
  if (holds) return;
  const auto known = [property](const std::string& line) { return line.starts_with(property); };
  if (std::any_of(broken.begin(), broken.end(), known)) return;
  std::string line(property);
  std::string_view separator = ": ";
  for (const quantity& q : example) {
    line += std::string(separator) + std::string(q.name) + " = " + pendular::detail::number(q.value);
    separator = ", ";
  }
  broken.push_back(line);
}

/// Relative to the larger of the two; numbers below `negligible` are all the same.
inline bool agree(double a, double b, double tolerance, double negligible = 1e-300) {
  if (!std::isfinite(a) || !std::isfinite(b)) return a == b;
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)) + negligible;
}

/// Gauss-Legendre with five points in each of many panels: 1e-9 for a function that decays over 1/200 of the range.
template <class Function>
double integral(const Function& f, double from, double to) {
  constexpr int panels = 400;
  constexpr double node[] = {0.0, 0.53846931010568309, 0.90617984593866399};
  constexpr double weight[] = {0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
  const double half = (to - from) / (2 * panels);
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const double middle = from + half * (2 * p + 1);
    sum += weight[0] * f(middle);
    for (int k = 1; k < 3; ++k) sum += weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
  }
  return half * sum;
}

}  // namespace pendular::testing
