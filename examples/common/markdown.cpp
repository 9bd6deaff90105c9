// SPDX-License-Identifier: BSD-3-Clause
#include "markdown.hpp"

#include <pendular/io/atomic_file.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace examples::markdown {

namespace {

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("'" + file.string() + "' cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Where the text between the markers begins and ends.
std::pair<std::size_t, std::size_t> place(const std::filesystem::path& file, const std::string& all,
                                          const std::string& name) {
  const std::string first = "<!-- " + name + " -->\n", last = "<!-- end of " + name + " -->";
  const std::size_t begin = all.find(first), end = all.find(last);
  if (begin == std::string::npos || end == std::string::npos) {
    throw std::runtime_error("'" + file.string() + "' has no markers for " + name);
  }
  return {begin + first.size(), end};
}

}  // namespace

table::table(const std::vector<std::string>& names) : text_(row(names) + "|") {
  for (std::size_t k = 0; k < names.size(); ++k) text_ += "---|";
  text_ += "\n";
}

void table::add(const std::vector<std::string>& cells) { text_ += row(cells); }

std::string number(const char* format, double value) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string number(const char* format, double value, double error) {
  return number(format, value) + " ± " + number(format, error);
}

void replace(const std::filesystem::path& file, const std::string& name, const std::string& text) {
  std::string all = read(file);
  const auto [begin, end] = place(file, all, name);
  all.replace(begin, end - begin, text);
  pendular::io::atomic_file out(file);
  out.write(all);
  out.commit();
}

std::string between(const std::filesystem::path& file, const std::string& name) {
  const std::string all = read(file);
  const auto [begin, end] = place(file, all, name);
  return all.substr(begin, end - begin);
}

}  // namespace examples::markdown
