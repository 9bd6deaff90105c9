// SPDX-License-Identifier: BSD-3-Clause
#include "run.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace paper {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> found;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_directory()) found.push_back(entry.path());
    }
  }
  // seed10 behind seed9
  std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) {
    const auto left = a.filename().string(), right = b.filename().string();
    return std::pair(left.size(), left) < std::pair(right.size(), right);
  });
  return found;
}

seeds runs_in(const fs::path& of_case) {
  seeds found;
  for (const fs::path& seed : folders_in(of_case)) {
    if (fs::exists(seed / "summary.json")) found.emplace_back(seed);
  }
  return found;
}

double as_number(const nlohmann::json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

run::run(const fs::path& folder) : folder_(folder) {
  std::ifstream in(folder / "summary.json");
  if (!in) throw std::runtime_error("there is no summary.json in " + folder.string());
  try {
    summary_ = nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error("summary.json in " + folder.string() + " is damaged: " + error.what());
  }
}

const nlohmann::json& run::entry(const std::string& part, const std::string& name) const {
  if (!summary_.contains(part) || !summary_[part].contains(name)) {
    throw std::runtime_error("summary.json in " + folder_.string() + " has no " + part + "." + name);
  }
  return summary_[part][name];
}

double run::number(const std::string& part, const std::string& name) const { return as_number(entry(part, name)); }

double run::number(const std::string& part, const std::string& name, std::size_t place) const {
  return as_number(entry(part, name).at(place));
}

double run::number(const std::string& part, const std::string& name, const std::string& key) const {
  const nlohmann::json& whole = entry(part, name);
  if (!whole.contains(key)) {
    throw std::runtime_error("summary.json in " + folder_.string() + " has no " + part + "." + name + "." + key);
  }
  return as_number(whole[key]);
}

std::string run::all_options() const { return " " + summary_.at("options").get<std::string>() + " "; }

bool run::has_option(const std::string& name) const {
  return all_options().find(" " + name + " ") != std::string::npos;
}

std::string run::option(const std::string& name) const {
  const std::string all = all_options(), key = " " + name + " ";
  const auto place = all.find(key);
  if (place == std::string::npos) throw std::runtime_error("no option " + name + " in " + folder_.string());
  const auto begin = place + key.size();
  return all.substr(begin, all.find(' ', begin) - begin);
}

double run::numeric_option(const std::string& name) const { return std::stod(option(name)); }

pendular::io::table run::curve() const {
  for (const char* name : {"shear_curve.csv", "stress_strain.csv"}) {
    if (fs::exists(folder_ / name)) return pendular::io::read_table(folder_ / name);
  }
  throw std::runtime_error("there is no curve in " + folder_.string());
}

std::vector<std::pair<std::string, seeds>> cases(const fs::path& folder) {
  std::vector<std::pair<std::string, seeds>> all;
  for (const fs::path& of_case : folders_in(folder)) {
    seeds found = runs_in(of_case);
    if (!found.empty()) all.emplace_back(of_case.filename().string(), std::move(found));
  }
  return all;
}

seeds runs_of(const fs::path& of_case) {
  seeds found = runs_in(of_case);
  if (found.empty()) throw std::runtime_error("no job has ended in " + of_case.string());
  return found;
}

seeds three_runs_of(const fs::path& of_case) {
  seeds found = runs_of(of_case);
  if (found.size() < 3) {
    throw std::runtime_error(std::to_string(found.size()) + " of 3 seeds have ended in " + of_case.string());
  }
  return found;
}

}  // namespace paper
