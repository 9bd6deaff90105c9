// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cost.hpp"
#include "misfit.hpp"

#include <filesystem>
#include <vector>

namespace figures {

/// Error against run time: who is on the front.
void pareto(const std::vector<misfit::summary>& laws, const std::vector<cost::of_law>& times,
            const std::filesystem::path& folder);

/// The paper's Figs. 1(b) and 1(c): its law and direct integration over the gap, and scaled by kappa R and lambda.
void paper(const std::filesystem::path& folder);

}  // namespace figures
