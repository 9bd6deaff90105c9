// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <charconv>
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

namespace detail {
inline std::string number(double value, int digits) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}

/// As many digits as it takes to tell different values apart.
inline int digits_for(std::initializer_list<quantity> example) {
  const auto look_alike = [&](int digits) {
    for (const quantity& a : example) {
      for (const quantity& b : example) {
        if (a.value < b.value && number(a.value, digits) == number(b.value, digits)) return true;
      }
    }
    return false;
  };
  int digits = 6;
  while (digits < 17 && look_alike(digits)) ++digits;
  return digits;
}
}  // namespace detail

/// Records the first counterexample to a property and ignores the others.
inline void demand(report& broken, bool holds, std::string_view property, std::initializer_list<quantity> example) {
  if (holds) return;
  const auto known = [property](const std::string& line) { return line.starts_with(property); };
  if (std::any_of(broken.begin(), broken.end(), known)) return;
  std::string line(property);
  const int digits = detail::digits_for(example);
  std::string_view separator = ": ";
  for (const quantity& q : example) {
    line += std::string(separator) + std::string(q.name) + " = " + detail::number(q.value, digits);
    separator = ", ";
  }
  broken.push_back(line);
}

/// Relative to the larger of the two; numbers below `negligible` are all the same.
inline bool agree(double a, double b, double tolerance, double negligible = 1e-300) {
  if (!std::isfinite(a) || !std::isfinite(b)) return a == b;
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)) + negligible;
}

/// To 1e-9 of itself for a function that decays over 1/200 of the range, to 1e-7 over a kink.
template <class Function>
double integral(const Function& f, double from, double to) {
  constexpr int panels = 400;
  const double width = (to - from) / panels;
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const auto part = [&](double x) { return f(from + width * (p + 0.5 * (1 + x))); };
    sum += boost::math::quadrature::gauss<double, 15>::integrate(part);
  }
  return 0.5 * width * sum;
}

}  // namespace pendular::testing
