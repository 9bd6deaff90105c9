// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

namespace pendular {

/// What is kept by value: it can be copied and written over. (std::copyable is the same of all types that are met here, and
/// makes a compiler look at six times as much for each.)
template <class T>
concept Copyable = std::is_copy_constructible_v<T> && std::is_copy_assignable_v<T>;

}  // namespace pendular
