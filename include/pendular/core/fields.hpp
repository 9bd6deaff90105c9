// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace pendular {

namespace detail {
struct anything {
  template <class T>
  operator T() const;
};

template <class S, std::size_t... I>
consteval bool takes(std::index_sequence<I...>) {
  return requires { S{((void)I, anything{})...}; };
}

template <class S, std::size_t N = 0>
consteval std::size_t field_count() {
  if constexpr (std::is_empty_v<S>) {
    return 0;
  } else if constexpr (!takes<S>(std::make_index_sequence<N + 1>{})) {
    return N;
  } else {
    return field_count<S, N + 1>();
  }
}
}  // namespace detail

/// visit(member) for every member of an aggregate of up to eight members, in order of declaration.
template <class S, class Visit>
void for_each_field(S& s, const Visit& visit) {
  constexpr std::size_t count = detail::field_count<std::remove_cv_t<S>>();
  static_assert(count <= 8, "a policy's memory or coefficients may have at most 8 members: group them in structs");
  if constexpr (count == 1) {
    auto& [a] = s;
    visit(a);
  } else if constexpr (count == 2) {
    auto& [a, b] = s;
    visit(a), visit(b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = s;
    visit(a), visit(b), visit(c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = s;
    visit(a), visit(b), visit(c), visit(d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = s;
    visit(a), visit(b), visit(c), visit(d), visit(e);
  } else if constexpr (count == 6) {
    auto& [a, b, c, d, e, f] = s;
    visit(a), visit(b), visit(c), visit(d), visit(e), visit(f);
  } else if constexpr (count == 7) {
    auto& [a, b, c, d, e, f, g] = s;
    visit(a), visit(b), visit(c), visit(d), visit(e), visit(f), visit(g);
  } else if constexpr (count == 8) {
    auto& [a, b, c, d, e, f, g, h] = s;
    visit(a), visit(b), visit(c), visit(d), visit(e), visit(f), visit(g), visit(h);
  }
}

/// visit(scalar) for every T inside an aggregate, members of members included.
template <class T, class S, class Visit>
void for_each_scalar(S& s, const Visit& visit) {
  if constexpr (std::is_same_v<std::remove_cv_t<S>, T>) {
    visit(s);
  } else {
    for_each_field(s, [&](auto& member) { for_each_scalar<T>(member, visit); });
  }
}

/// How many T an aggregate holds.
template <class T, class S>
constexpr std::size_t scalar_count = sizeof(S) / sizeof(T);
template <class T, class S>
  requires std::is_empty_v<S>
constexpr std::size_t scalar_count<T, S> = 0;

}  // namespace pendular
