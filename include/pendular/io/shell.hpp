// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

namespace pendular::io::shell {

/// `text` as one word of a POSIX shell command, whatever it contains.
inline std::string quoted(std::string_view text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string{"'\\''"} : std::string(1, c);
  return word + "'";
}

struct outcome {
  int status;          // exit code; missing when the program is not installed
  std::string output;  // standard output and error together

  static constexpr int missing = 127;  // POSIX: command not found
};

/// Runs `command` through /bin/sh and waits for it.
inline outcome run(const std::string& command) {
  std::FILE* pipe = ::popen(("{ " + command + "; } 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return {-1, "no new process can be started"};
  std::string output;
  std::array<char, 4096> block;
  while (const auto size = std::fread(block.data(), 1, block.size(), pipe)) output.append(block.data(), size);
  const int status = ::pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

/// The first line of `output` that contains `word`, else its last line that is not empty.
inline std::string telling_line(std::string_view output, std::string_view word) {
  std::string_view last;
  while (!output.empty()) {
    const auto line = output.substr(0, output.find('\n'));
    if (line.find(word) != std::string_view::npos) return std::string{line};
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) last = line;
    output.remove_prefix(line.size() < output.size() ? line.size() + 1 : line.size());
  }
  return std::string{last};
}

}  // namespace pendular::io::shell
