// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

namespace pendular {

namespace detail {
/// ask(memory) of a law that remembers, ask() of others, which may be handed any memory or none.
template <class Law, class T, class Ask, class... Memory>
decltype(auto) ask_with(const Ask& ask, Memory&... memory) {
  if constexpr (Remembers<Law, T>) {
    static_assert(sizeof...(Memory) == 1, "a law that remembers is asked with its memory");
    return ask(memory...);
  } else {
    return ask();
  }
}
}  // namespace detail

/// Push of a damping law beside the given spring, N, whether it looks at the stiffness alone or at the push as well,
/// and with its memory if it remembers.
template <DampingLaw Law, Scalar T, class... Memory>
T resistance(const Law& law, const approach<T>& a, const elastic<T>& spring, Memory&... memory) {
  const auto ask = [&](auto&... own) -> T {
    if constexpr (detail::ResistsBeside<Law, T>) {
      return law.resistance(a, spring, own...);
    } else {
      return law.resistance(a, spring.stiffness, own...);
    }
  };
  return detail::ask_with<Law, T>(ask, memory...);
}

}  // namespace pendular
