// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace pendular::io {

/// The shortest decimal text that reads back as exactly `value`, in any locale; "nan", "inf", "-inf" as such.
inline std::string shortest(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace pendular::io
