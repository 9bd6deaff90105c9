// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#if defined(__AVX__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#if defined(__i386__) && !defined(__SSE2__)
#error "pendular needs registers that round every result: compile 32-bit programs with -msse2 -mfpmath=sse"
#endif

// Names of lanes, and of the functions here that take or return them, carry the width of registers, because it decides how
// they are passed: parts of a program with different flags do not take each other's functions and read lanes from where
// they are not. A system has one name in all of them, so such parts must not share one.
#if defined(__AVX512F__)
#define PENDULAR_REGISTERS registers_of_64
#elif defined(__AVX__)
#define PENDULAR_REGISTERS registers_of_32
#else
#define PENDULAR_REGISTERS registers_of_16
#endif

// One register of the build's own width, and the few things that the compilers' vector extension has no operator for.
namespace pendular::simd {
inline namespace PENDULAR_REGISTERS {

#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
inline constexpr std::string_view instruction_set = "AVX-512";
#elif defined(__AVX__)
inline constexpr int register_bytes = 32;
inline constexpr std::string_view instruction_set = "AVX";
#else
inline constexpr int register_bytes = 16;
inline constexpr std::string_view instruction_set = "registers of 16 bytes";
#endif

template <class E, int W>
using vector_of [[gnu::vector_size(W * sizeof(E))]] = E;

template <class V>
using element_of = std::remove_cvref_t<decltype(std::declval<V>()[0])>;

/// The whole number as wide as E, of which comparisons make -1 for true and 0 for false.
template <class E>
using truth_of = element_of<decltype(std::declval<vector_of<E, 2>>() < std::declval<vector_of<E, 2>>())>;

namespace detail {
/// Whether V is a register of doubles of so many bytes that intrinsics take.
template <class V, int Bytes>
inline constexpr bool is_doubles =
#if defined(__SSE2__)
    std::is_same_v<element_of<V>, double> && sizeof(V) == Bytes;
#else
    false;
#endif
}  // namespace detail

/// From anywhere. By intrinsics, because g++ 12 copies 32 bytes in two pieces, which a load of the whole then waits for.
template <class V>
[[gnu::always_inline]] inline V read(const element_of<V>* from) {
#if defined(__SSE2__)
  if constexpr (detail::is_doubles<V, 16>) return (V)_mm_loadu_pd(from);
#endif
#if defined(__AVX__)
  if constexpr (detail::is_doubles<V, 32>) return (V)_mm256_loadu_pd(from);
#endif
#if defined(__AVX512F__)
  if constexpr (detail::is_doubles<V, 64>) return (V)_mm512_loadu_pd(from);
#endif
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class V>
[[gnu::always_inline]] inline void write(element_of<V>* to, const V& v) {
#if defined(__SSE2__)
  if constexpr (detail::is_doubles<V, 16>) return _mm_storeu_pd(to, (__m128d)v);
#endif
#if defined(__AVX__)
  if constexpr (detail::is_doubles<V, 32>) return _mm256_storeu_pd(to, (__m256d)v);
#endif
#if defined(__AVX512F__)
  if constexpr (detail::is_doubles<V, 64>) return _mm512_storeu_pd(to, (__m512d)v);
#endif
  std::memcpy(to, &v, sizeof v);
}

/// b where a < b, else a: what is no number in a stays. One instruction, where a comparison and a choice take three.
/// With a full mask, because g++ 12 takes the unmasked form for a use of something uninitialised.
template <class V>
[[gnu::always_inline]] inline V larger(const V& a, const V& b) {
#if defined(__SSE2__)
  if constexpr (detail::is_doubles<V, 16>) return (V)_mm_max_pd((__m128d)b, (__m128d)a);
#endif
#if defined(__AVX__)
  if constexpr (detail::is_doubles<V, 32>) return (V)_mm256_max_pd((__m256d)b, (__m256d)a);
#endif
#if defined(__AVX512F__)
  if constexpr (detail::is_doubles<V, 64>) return (V)_mm512_maskz_max_pd(0xff, (__m512d)b, (__m512d)a);
#endif
  return a < b ? b : a;
}

/// b where b < a, else a.
template <class V>
[[gnu::always_inline]] inline V smaller(const V& a, const V& b) {
#if defined(__SSE2__)
  if constexpr (detail::is_doubles<V, 16>) return (V)_mm_min_pd((__m128d)b, (__m128d)a);
#endif
#if defined(__AVX__)
  if constexpr (detail::is_doubles<V, 32>) return (V)_mm256_min_pd((__m256d)b, (__m256d)a);
#endif
#if defined(__AVX512F__)
  if constexpr (detail::is_doubles<V, 64>) return (V)_mm512_maskz_min_pd(0xff, (__m512d)b, (__m512d)a);
#endif
  return b < a ? b : a;
}

template <class V>
[[gnu::always_inline]] inline V square_root(const V& a) {
#if defined(__SSE2__)
  if constexpr (detail::is_doubles<V, 16>) return (V)_mm_sqrt_pd((__m128d)a);
#endif
#if defined(__AVX__)
  if constexpr (detail::is_doubles<V, 32>) return (V)_mm256_sqrt_pd((__m256d)a);
#endif
#if defined(__AVX512F__)
  if constexpr (detail::is_doubles<V, 64>) return (V)_mm512_maskz_sqrt_pd(0xff, (__m512d)a);
#endif
  V root = a;
  for (std::size_t k = 0; k < sizeof(V) / sizeof(element_of<V>); ++k) {
    root[k] = static_cast<element_of<V>>(std::sqrt(a[k]));
  }
  return root;
}

template <class V>
[[gnu::always_inline]] inline V absolute(const V& a) {
  using truth = truth_of<element_of<V>>;
  using bits = vector_of<truth, sizeof(V) / sizeof(truth)>;
  return (V)((bits)a & std::numeric_limits<truth>::max());
}

/// Whether a register of truths, -1 or 0, has one that is not 0.
template <class V>
[[gnu::always_inline]] inline bool any_true(const V& v) {
#if defined(__AVX512F__)
  if constexpr (sizeof(V) == 64) return _mm512_test_epi32_mask((__m512i)v, (__m512i)v) != 0;
#endif
#if defined(__AVX__)
  if constexpr (sizeof(V) == 32) return _mm256_movemask_ps((__m256)v) != 0;
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(V) == 16) return _mm_movemask_ps((__m128)v) != 0;
#endif
  bool found = false;
  for (std::size_t k = 0; k < sizeof(V) / sizeof(element_of<V>); ++k) found |= v[k] != 0;
  return found;
}

}  // namespace PENDULAR_REGISTERS
}  // namespace pendular::simd
