// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/none.hpp>

namespace pendular::friction {
using none = pendular::none;
}  // namespace pendular::friction
