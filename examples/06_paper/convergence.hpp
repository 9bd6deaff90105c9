// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measured.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

// How far the strengths depend on what is not physics, against what it costs.
namespace paper::convergence {

/// One setting in a study.
struct point {
  std::string value;
  measured stress;    // Pa
  measured change;    // from the finest setting, of the stress of the finest
  double time;        // of the processor in the test, median, over that of the reference
  double worst_book;  // energy imbalance over turnover
  std::size_t seeds;
};

/// All settings of one kind for one test; the finest is the first.
struct study {
  std::string test;  // shear or compression
  std::string name;
  std::string title;
  std::vector<point> points;
};

/// All of one test; without points if none of its jobs has come to its end. Errors: std::runtime_error if the reference has
/// not.
std::vector<study> read(const std::filesystem::path& folder, const std::string& test);

std::string table_of(const std::vector<study>& studies, const std::string& test);
void draw(const std::vector<study>& studies, const std::string& test, const std::filesystem::path& file);

/// Every capillary law: strength, what it adds to the dry shear stress, and what it costs.
std::string table_of_laws(const std::filesystem::path& folder);

/// Strength under Eq. 12 for every gamma_t and speed, and what is left of the stress towards the end of the test.
struct rate_point {
  double viscosity, speed;  // N s/m, m/s
  measured stress;          // Pa
  measured left;            // 1 if the stress neither falls nor rises
  std::size_t seeds;
};
/// Errors: std::runtime_error if no job has come to its end.
std::vector<rate_point> read_rates(const std::filesystem::path& folder);
std::string table_of(const std::vector<rate_point>& rates);
void draw(const std::vector<rate_point>& rates, const std::filesystem::path& file);

}  // namespace paper::convergence
