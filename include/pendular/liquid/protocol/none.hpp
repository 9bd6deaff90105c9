// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/none.hpp>

namespace pendular::protocol {
/// Liquid of a broken bond stays on its grains and is not used again.
using none = pendular::none;
}  // namespace pendular::protocol
