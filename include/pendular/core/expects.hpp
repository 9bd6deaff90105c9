// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pendular {

/// Bad input, found at the border before anything is changed.
struct input_error : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A run that cannot go on: names grain, step and cause.
struct run_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {
inline std::string number(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}
}  // namespace detail

/// One sentence: what was given, its value, the bound it breaks, where to read.
inline std::string complaint(std::string_view what, double value, std::string_view bound, std::string_view where) {
  return std::string(what) + " is " + detail::number(value) + ", but must be " + std::string(bound) + " (see " +
         std::string(where) + ")";
}

inline void expects(bool holds, std::string_view what, double value, std::string_view bound, std::string_view where) {
  if (!holds) throw input_error(complaint(what, value, bound, where));
}

inline void expects_positive(std::string_view what, double value, std::string_view where) {
  expects(value > 0 && std::isfinite(value), what, value, "positive and finite", where);
}

}  // namespace pendular
