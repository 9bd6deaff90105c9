// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

// What decides the shear curve besides the liquid: how the sample is made, the friction law, speed, mass and step, which pairs
// are wet. Each answers tables for the page; `folder` is that of the campaign. Errors: std::runtime_error if a job has not come
// to its end.
namespace paper::shear {

/// Four ways to make the sample, two friction laws. Draws into `figures`.
std::string choices(const std::filesystem::path& folder, const std::filesystem::path& figures);

/// Eq. 12 at several speeds: what of its intercept is the liquid's, what its own.
std::string speeds(const std::filesystem::path& folder);

/// Eq. 12 at the paper's step, at a longer one, and with more mass: error against run time.
std::string settings(const std::filesystem::path& folder);

/// Touching pairs only, against all eligible ones.
std::string wet_pairs(const std::filesystem::path& folder);

/// Protocols in the shear, and another water content with as many bonds.
std::string protocols(const std::filesystem::path& folder);

}  // namespace paper::shear
