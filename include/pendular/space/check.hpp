// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/never.hpp>
#include <pendular/space/grains.hpp>

#include <concepts>
#include <string_view>

namespace pendular::check {

// A ladder as those of laws (law/check.hpp): true, or one sentence for the first clause that is broken.

template <class T>
consteval bool is_grain_tag() {
  using pendular::detail::never;
  if constexpr (!requires { typename T::type; }) {
    static_assert(never<T>, "a tag of grains needs the type of its value: `using type = double` "
                            "(docs/reference/grains.md)");
  } else if constexpr (!requires {
                         { T::label } -> std::convertible_to<std::string_view>;
                         { T::unit } -> std::convertible_to<std::string_view>;
                       }) {
    static_assert(never<T>, "a tag of grains needs `static constexpr std::string_view label` and `unit` "
                            "(docs/reference/grains.md)");
  } else if constexpr (!GrainTag<T>) {
    static_assert(never<T>, "the value of a tag of grains is a double, a std::int64_t or a vector "
                            "(docs/reference/grains.md)");
  }
  return true;
}

template <class T>
inline constexpr bool grain_tag = is_grain_tag<T>();

}  // namespace pendular::check
