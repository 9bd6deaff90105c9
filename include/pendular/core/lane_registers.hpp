// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/simd_register.hpp>

namespace pendular::simd {
inline namespace PENDULAR_REGISTERS {

/// W numbers in as many registers as they need: halves of halves, so that the compiler sees values and no array.
template <class E, int W>
struct registers {
  registers<E, W / 2> low, high;
};
template <class E, int W>
  requires(static_cast<int>(sizeof(E)) * W <= register_bytes)
struct registers<E, W> {
  vector_of<E, W> value;
};

template <class E, int W>
inline constexpr bool is_one_register = static_cast<int>(sizeof(E)) * W <= register_bytes;

/// f of every register, or of every pair or triple of registers side by side, which makes one of R.
template <class R, class F, class E, int W, class... Others>
[[gnu::always_inline]] inline registers<R, W> map(const F& f, const registers<E, W>& a, const Others&... others) {
  if constexpr (is_one_register<E, W>) {
    return {f(a.value, others.value...)};
  } else {
    return {map<R>(f, a.low, others.low...), map<R>(f, a.high, others.high...)};
  }
}

template <class E, int W>
[[gnu::always_inline]] inline registers<E, W> filled_with(E value) {
  if constexpr (is_one_register<E, W>) {
    return {value - vector_of<E, W>{}};  // a difference from zero, because a sum would lose the sign of minus zero
  } else {
    const auto half = filled_with<E, W / 2>(value);
    return {half, half};
  }
}

template <class E, int W>
[[gnu::always_inline]] inline registers<E, W> read_from(const E* from) {
  if constexpr (is_one_register<E, W>) {
    return {read<vector_of<E, W>>(from)};
  } else {
    return {read_from<E, W / 2>(from), read_from<E, W / 2>(from + W / 2)};
  }
}

template <class E, int W>
[[gnu::always_inline]] inline void write_to(E* to, const registers<E, W>& from) {
  if constexpr (is_one_register<E, W>) {
    write(to, from.value);
  } else {
    write_to(to, from.low);
    write_to(to + W / 2, from.high);
  }
}

template <class E, int W>
[[gnu::always_inline]] inline E element_at(const registers<E, W>& r, int k) {
  if constexpr (is_one_register<E, W>) {
    return r.value[k];
  } else {
    return k < W / 2 ? element_at(r.low, k) : element_at(r.high, k - W / 2);
  }
}

template <class E, int W>
inline bool any_true_in(const registers<E, W>& r) {
  if constexpr (is_one_register<E, W>) {
    return any_true(r.value);
  } else {
    return any_true_in(map<E>([](const auto& a, const auto& b) { return a | b; }, r.low, r.high));
  }
}

}  // namespace PENDULAR_REGISTERS
}  // namespace pendular::simd
