// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/shell.hpp>

#include <cmath>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

// Other codes' programs: what they say, and the numbers in it.
namespace peers {

inline bool is_installed(const std::string& program) {
  return pendular::io::shell::run("command -v " + pendular::io::shell::quoted(program)).status == 0;
}

inline std::string last_lines(const std::string& text, int lines = 12) {
  std::size_t begin = text.size();
  for (int k = 0; k <= lines && begin != 0 && begin != std::string::npos; ++k) begin = text.rfind('\n', begin - 1);
  return begin == std::string::npos ? text : text.substr(begin);
}

/// Output of a command on one core that ends within ten minutes. `settings` are variables of its environment.
inline std::string output_of(const std::string& settings, const std::string& command) {
  const auto outcome = pendular::io::shell::run("OMP_NUM_THREADS=1 " + settings + " timeout 600 " + command);
  if (outcome.status == 0) return outcome.output;
  throw std::runtime_error("'" + command + "' failed with status " + std::to_string(outcome.status) +
                           "; its last lines:\n" + last_lines(outcome.output));
}

/// The numbers that the last match of a pattern in the output of a program has in its parentheses.
inline std::vector<double> numbers_in(const std::string& output, const std::string& program,
                                      const std::string& pattern) {
  const std::regex form(pattern);
  std::smatch last;
  for (std::sregex_iterator at(output.begin(), output.end(), form), end; at != end; ++at) last = *at;
  std::vector<double> numbers;
  for (std::size_t k = 1; k < last.size(); ++k) {
    char* rest = nullptr;
    const std::string word = last[k].str();
    numbers.push_back(std::strtod(word.c_str(), &rest));
    if (rest != word.c_str() + word.size() || !std::isfinite(numbers.back())) numbers.clear(), last = {};
  }
  if (numbers.empty())
    throw std::runtime_error("the output of '" + program + "' has no numbers as in '" + pattern +
                             "'; its last lines:\n" + last_lines(output));
  return numbers;
}

}  // namespace peers
