// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cost.hpp"
#include "misfit.hpp"

#include <filesystem>
#include <string>
#include <vector>

// The study as Markdown tables, and as the part of a page between two markers.
namespace page {

std::string errors(const std::vector<misfit::summary>& laws, const std::vector<misfit::rupture_summary>& ruptures);
std::string times(const std::vector<cost::of_law>& laws);

/// Puts text between `<!-- name -->` and `<!-- end of name -->`. Errors: std::runtime_error without a file or markers.
void replace(const std::filesystem::path& file, const std::string& name, const std::string& text);

/// What stands there now.
std::string between(const std::filesystem::path& file, const std::string& name);

}  // namespace page
