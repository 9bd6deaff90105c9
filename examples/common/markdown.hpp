// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace examples::markdown {

/// A table, line by line.
class table {
 public:
  explicit table(const std::vector<std::string>& names);
  void add(const std::vector<std::string>& cells);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// `value` in the format of printf; a dash if it is not a number.
std::string number(const char* format, double value);
/// The same with the error behind a plus-minus sign.
std::string number(const char* format, double value, double error);

/// Puts text between `<!-- name -->` and `<!-- end of name -->`. Errors: std::runtime_error without a file or markers.
void replace(const std::filesystem::path& file, const std::string& name, const std::string& text);

/// What stands there now.
std::string between(const std::filesystem::path& file, const std::string& name);

}  // namespace examples::markdown
