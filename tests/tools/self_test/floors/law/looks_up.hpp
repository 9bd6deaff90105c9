// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/core/scalar.hpp>
#include <pendular/system.hpp>
#include <range/v3/view/zip.hpp>
#include "inputs.hpp"
