// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/parameters.hpp>
#include <pendular/io/state/records.hpp>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pendular::io {

/// Whose parameters hold where those of a checkpoint and of the program that reads it differ.
/// `file_for_walls`: the file's for the walls, which stages of a test drive differently, and nobody's for all else.
enum class winner { nobody, file, program, file_for_walls };

namespace detail {

inline void put_parameters(checkpoint_writer& out, const std::vector<parameter>& all) {
  std::string names;
  std::vector<double> values;
  for (const parameter& p : all) {
    names += p.name + '\n';
    values.push_back(p.value);
  }
  out.put("system.parameter_names", std::string_view{names});
  out.put("system.parameters", values);
}
inline std::vector<parameter> get_parameters(const checkpoint_reader& in) {
  std::istringstream names(in.get<std::string>("system.parameter_names"));
  std::vector<parameter> all;
  for (std::string name; std::getline(names, name);) all.push_back({name, 0});
  const auto values = in.get<std::vector<double>>("system.parameters", all.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k].value = values[k];
  return all;
}

/// Compares the parameters of the file with those of the program and takes those that win.
template <class System>
std::vector<std::string> settle_parameters(const checkpoint_reader& in, System& s, winner wins) {
  const std::vector<parameter> file = get_parameters(in);
  const std::vector<std::string> differing = differences(file, parameters_of(s));
  std::string refused;
  for (const std::string& line : differing) {
    const bool of_wall = line.rfind("wall ", 0) == 0;
    const bool fine = wins == winner::file || wins == winner::program || (wins == winner::file_for_walls && of_wall);
    if (!fine) refused += (refused.empty() ? "" : "; ") + line;
  }
  if (!refused.empty()) {
    throw std::runtime_error("the checkpoint was written with other parameters: " + refused +
                             " (say who wins, or resume with those of the file; see docs/how-to/resume.md)");
  }
  if (wins == winner::file || wins == winner::file_for_walls) take_parameters(s, file);
  s.for_each_policy([](const auto& policy) {
    if constexpr (requires { validate(policy); }) validate(policy);
  });
  if constexpr (System::wet) s.bridges().policies().check();
  return differing;
}

/// The drives of the walls as the program has them, put back over what the file had.
template <class System>
std::vector<parameter> wall_parameters(const System& s) {
  std::vector<parameter> of_walls;
  for (const parameter& p : parameters_of(s)) {
    if (p.name.rfind("wall ", 0) == 0) of_walls.push_back(p);
  }
  return of_walls;
}

}  // namespace detail

}  // namespace pendular::io
