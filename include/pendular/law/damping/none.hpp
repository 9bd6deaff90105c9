// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/none.hpp>

namespace pendular::damping {
using none = pendular::none;
}  // namespace pendular::damping
