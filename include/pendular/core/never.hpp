// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pendular::detail {

/// False, but only once the template around it is instantiated: for a static_assert in a branch not to be taken.
template <class>
inline constexpr bool never = false;

}  // namespace pendular::detail
