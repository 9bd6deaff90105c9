// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

// The direct-shear part of the paper: Figs. 5 and 7. Each draws into `figures` and answers tables for the page; `folder` is
// that of the campaign. Errors: std::runtime_error if a job has not come to its end.
namespace paper::shear {

std::string stress_curves(const std::filesystem::path& folder, const std::filesystem::path& figures);
std::string bonds(const std::filesystem::path& folder, const std::filesystem::path& figures);

}  // namespace paper::shear
