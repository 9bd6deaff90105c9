// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#define PENDULAR_VERSION_MAJOR 0
#define PENDULAR_VERSION_MINOR 1
#define PENDULAR_VERSION_PATCH 0
