// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contender.hpp"

#include <pendular/io/atomic_file.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// The comparison as Markdown.
namespace peers::report {

template <class... Numbers>
std::string formatted(const char* form, Numbers... numbers) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), form, numbers...);
  return text.data();
}

inline std::string row(const contender& c) {
  const measurement& m = c.rounds.back();
  const double interactions = std::max(m.contacts, m.bridges);
  return "| " + c.code + " | " + c.scene + " | " +
         formatted("%.0f | %.2f | %.2f | %.0f | %.1f |\n", c.time(), m.contacts, m.bridges, c.time() / interactions,
                   1e12 * m.kinetic_energy);
}

inline std::string table(const std::vector<contender>& all) {
  std::string text = "| code | scene | ns per grain and step | contacts per grain | bridges per grain | ns per "
                     "interaction and step | kinetic energy, pJ per grain |\n|---|---|---|---|---|---|---|\n";
  for (const contender& c : all) text += row(c);
  return text;
}

inline std::string ratio_row(const contender& one, const contender& other) {
  const ratio r = time_ratio(one, other);
  return "| " + one.code + " " + one.scene + " / " + other.code + " " + other.scene + " | " +
         formatted("%.2f | %.2f to %.2f |\n", r.median, r.smallest, r.largest);
}

/// Puts text between `<!-- name -->` and `<!-- end of name -->`.
inline void replace(const std::filesystem::path& page, const std::string& name, const std::string& text) {
  std::ifstream in(page);
  std::string all{std::istreambuf_iterator<char>(in), {}};
  const std::string first = "<!-- " + name + " -->\n", last = "<!-- end of " + name + " -->";
  const std::size_t begin = all.find(first), end = all.find(last);
  if (begin == std::string::npos || end == std::string::npos)
    throw std::runtime_error("'" + page.string() + "' has no markers for " + name);
  all.replace(begin + first.size(), end - begin - first.size(), text);
  pendular::io::atomic_file out(page);
  out.write(all);
  out.commit();
}

}  // namespace peers::report
