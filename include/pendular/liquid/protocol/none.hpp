// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pendular::protocol {

/// Liquid of a broken bond stays on its grains and is not used again.
struct none {
  using moves_nothing = void;
};

}  // namespace pendular::protocol
