// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace examples {

/// What differs from the paper, a line each.
class departures {
 public:
  explicit departures(std::vector<std::string> before = {}) : lines_(std::move(before)) {}

  /// A line of these parts, if it differs.
  template <class... Parts>
  void add(bool differs, const Parts&... parts) {
    if (!differs) return;
    std::ostringstream text;
    (text << ... << parts);
    lines_.push_back(text.str());
  }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

}  // namespace examples
