// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace paper::companion {

/// The microstructure of the samples of which three seeds have been relaxed, and the companion paper's numbers (Richefeu et
/// al. 2006, Eur. Phys. J. E 21, 359) beside. Errors: std::runtime_error if no case has its seeds.
std::string table_of_samples(const std::filesystem::path& folder);

}  // namespace paper::companion
