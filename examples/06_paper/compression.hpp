// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

// The simple-compression part of the paper: Figs. 10 to 12. Each draws into `figures` and answers tables for the page;
// `folder` is that of the campaign. Errors: std::runtime_error if a job has not come to its end.
namespace paper::compression {

std::string stress_curves(const std::filesystem::path& folder, const std::filesystem::path& figures);
std::string strengths(const std::filesystem::path& folder, const std::filesystem::path& figures);
std::string still_zone(const std::filesystem::path& folder, const std::filesystem::path& figures);
std::string relaxation(const std::filesystem::path& folder);
/// How a sample with Eq. 12 creeps under its own weight before the test, and its strength afterwards.
std::string settlement(const std::filesystem::path& folder, const std::filesystem::path& figures);
/// Touching pairs only, against all eligible ones.
std::string wet_pairs(const std::filesystem::path& folder);

}  // namespace paper::compression
