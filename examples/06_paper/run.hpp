// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/table.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace paper {

/// A job that has come to its end: a folder with summary.json and a curve.
class run {
 public:
  /// Errors: std::runtime_error if the summary cannot be read.
  explicit run(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  /// Of the summary; not a number if it is null. Errors: std::runtime_error if there is no such entry.
  double number(const std::string& part, const std::string& name) const;
  /// Of an entry that is a list.
  double number(const std::string& part, const std::string& name, std::size_t place) const;
  /// Of an entry that has parts itself.
  double number(const std::string& part, const std::string& name, const std::string& key) const;
  bool has_option(const std::string& name) const;
  /// An option as it was given on the command line or by default.
  std::string option(const std::string& name) const;
  double numeric_option(const std::string& name) const;
  pendular::io::table curve() const;

 private:
  std::string all_options() const;  // between blanks
  const nlohmann::json& entry(const std::string& part, const std::string& name) const;

  std::filesystem::path folder_;
  nlohmann::json summary_;
};

/// Runs that differ by their seed, in its order.
using seeds = std::vector<run>;

/// All cases beneath a folder, <case>/seed<k>, the shorter names first, then by name. Empty if there is no such folder.
std::vector<std::pair<std::string, seeds>> cases(const std::filesystem::path& folder);

/// The runs of one case. Errors: std::runtime_error if there is none.
seeds runs_of(const std::filesystem::path& of_case);

/// The same of a case with the three seeds that a claim needs. Errors: std::runtime_error if there are fewer.
seeds three_runs_of(const std::filesystem::path& of_case);

/// f(a, b) of the runs with the same seed, which have the same packing.
template <class F>
std::vector<double> by_seed(const seeds& some, const seeds& others, const F& f) {
  std::vector<double> values;
  for (const run& a : some) {
    for (const run& b : others) {
      if (a.option("seed") == b.option("seed")) values.push_back(f(a, b));
    }
  }
  return values;
}

/// One number of every run.
template <class Value>
std::vector<double> each(const seeds& s, const Value& value) {
  std::vector<double> values;
  for (const run& r : s) values.push_back(value(r));
  return values;
}

}  // namespace paper
