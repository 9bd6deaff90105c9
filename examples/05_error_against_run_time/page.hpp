// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cost.hpp"
#include "misfit.hpp"

#include <string>
#include <vector>

// The study as Markdown tables.
namespace page {

std::string errors(const std::vector<misfit::summary>& laws, const std::vector<misfit::rupture_summary>& ruptures);
std::string times(const std::vector<cost::of_law>& laws);

}  // namespace page
