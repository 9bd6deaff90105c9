// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "catch.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

// Reports of kits in tests.

inline void check_sound(const std::vector<std::string>& found) {
  for (const std::string& broken : found) FAIL_CHECK(broken);
  SUCCEED();
}

/// The report has a line that begins, after what may name a part, with this.
inline bool finds(const std::vector<std::string>& found, std::string_view beginning) {
  for (const std::string& line : found) UNSCOPED_INFO(line);
  return std::any_of(found.begin(), found.end(), [&](const std::string& line) {
    return line.starts_with(beginning) || line.find(": " + std::string(beginning)) != std::string::npos;
  });
}
