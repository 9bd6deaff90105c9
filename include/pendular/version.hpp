// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// CMakeLists.txt reads the three numbers from here.
#define PENDULAR_VERSION_MAJOR 0
#define PENDULAR_VERSION_MINOR 1
#define PENDULAR_VERSION_PATCH 0

/// One number to compare: #if PENDULAR_VERSION >= 100 is 0.1.0 or newer.
#define PENDULAR_VERSION (10000 * PENDULAR_VERSION_MAJOR + 100 * PENDULAR_VERSION_MINOR + PENDULAR_VERSION_PATCH)
