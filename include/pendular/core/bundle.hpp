// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/none.hpp>

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace pendular::detail {

/// How many of the policies play the role; Role is a stateless callable template `role.operator()<Policy>() -> bool`.
template <auto Role, class... Policies>
consteval std::size_t players() {
  return (std::size_t{0} + ... + (Role.template operator()<Policies>() ? 1 : 0));
}

template <auto Role, class... Policies>
consteval std::size_t index_of_player() {
  std::size_t index = 0;
  bool found = false;
  ((found = found || Role.template operator()<Policies>(), index += found ? 0 : 1), ...);
  return index;
}

/// The policy that plays the role, or `none`.
template <auto Role, class... Policies>
const auto& player(const std::tuple<Policies...>& policies) {
  constexpr std::size_t index = index_of_player<Role, Policies...>();
  if constexpr (index < sizeof...(Policies)) {
    return std::get<index>(policies);
  } else {
    static constexpr none nobody{};
    return nobody;
  }
}

template <auto Role, class... Policies>
using player_t = std::remove_cvref_t<decltype(player<Role>(std::declval<const std::tuple<Policies...>&>()))>;

}  // namespace pendular::detail
