// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>

#include <cstdint>
#include <type_traits>

namespace pendular {

static_assert(lane_count == 8, "gather and store of quads are written for blocks of eight");

/// Four numbers of one grain or pair side by side, read and written at once.
struct alignas(32) quad {
  double a, b, c, d;
};

/// Eight numbers, two quads in one line of the cache.
struct alignas(64) octet {
  quad low, high;
};

namespace simd {
inline namespace PENDULAR_REGISTERS {

/// The same of a block of rows, number by number.
struct quad_block {
  block a, b, c, d;
};

/// Rows that are four doubles, which is not asked.
template <class Row>
concept FourDoubles = std::is_trivially_copyable_v<Row> && sizeof(Row) == sizeof(quad) && alignof(Row) == alignof(quad);

/// A row as it lies in memory, in one register or two.
template <FourDoubles Row>
[[gnu::always_inline]] inline registers<double, 4> read_row(const Row& row) {
  return read_from<double, 4>(reinterpret_cast<const double*>(&row));
}
[[gnu::always_inline]] inline void write_row(quad& row, const registers<double, 4>& r) {
  write_to(reinterpret_cast<double*>(&row), r);
}

/// Four registers as the rows of a matrix, which becomes its transpose; where a register holds two such rows, of both.
template <class V>
[[gnu::always_inline]] inline void transpose(V& a, V& b, V& c, V& d) {
  if constexpr (sizeof(V) == 64) {
    const V ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const V ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const V cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const V cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 4, 5, 12, 13);
    b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 4, 5, 12, 13);
    c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 10, 11, 6, 7, 14, 15);
    d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 10, 11, 6, 7, 14, 15);
  } else {
    const V ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const V cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
  }
}

/// The same of rows that need two registers each.
template <class Four>
[[gnu::always_inline]] inline void transpose_halves(Four& a, Four& b, Four& c, Four& d) {
  if constexpr (is_one_register<double, 4>) {
    transpose(a.value, b.value, c.value, d.value);
  } else {
    const auto first = [](const auto& x, const auto& y) { return __builtin_shufflevector(x, y, 0, 2); };
    const auto second = [](const auto& x, const auto& y) { return __builtin_shufflevector(x, y, 1, 3); };
    const Four x{{first(a.low.value, b.low.value)}, {first(c.low.value, d.low.value)}};
    const Four y{{second(a.low.value, b.low.value)}, {second(c.low.value, d.low.value)}};
    const Four z{{first(a.high.value, b.high.value)}, {first(c.high.value, d.high.value)}};
    d = {{second(a.high.value, b.high.value)}, {second(c.high.value, d.high.value)}};
    a = x, b = y, c = z;
  }
}

/// Two rows of four in one line.
template <class Four>
[[gnu::always_inline]] inline registers<double, 8> joined(const Four& low, const Four& high) {
  if constexpr (is_one_register<double, 8>) {
    return {__builtin_shufflevector(low.value, high.value, 0, 1, 2, 3, 4, 5, 6, 7)};
  } else {
    return {low, high};
  }
}
template <class Eight>
[[gnu::always_inline]] inline registers<double, 4> low_half(const Eight& r) {
  if constexpr (is_one_register<double, 8>) {
    return {__builtin_shufflevector(r.value, r.value, 0, 1, 2, 3)};
  } else {
    return r.low;
  }
}
template <class Eight>
[[gnu::always_inline]] inline registers<double, 4> high_half(const Eight& r) {
  if constexpr (is_one_register<double, 8>) {
    return {__builtin_shufflevector(r.value, r.value, 4, 5, 6, 7)};
  } else {
    return r.high;
  }
}

/// Both halves of the four are matrices of four by four.
template <class Eight>
[[gnu::always_inline]] inline void transpose_both(Eight& a, Eight& b, Eight& c, Eight& d) {
  if constexpr (is_one_register<double, 8>) {
    transpose(a.value, b.value, c.value, d.value);
  } else {
    transpose_halves(a.low, b.low, c.low, d.low);
    transpose_halves(a.high, b.high, c.high, d.high);
  }
}

/// The first three numbers of one row and the fourth of another. In the register: a number written on its own would make
/// the next reader of the row wait.
template <class Four>
[[gnu::always_inline]] inline Four three_and_fourth(const Four& three, const Four& fourth) {
  if constexpr (is_one_register<double, 4>) {
    return {__builtin_shufflevector(three.value, fourth.value, 0, 1, 2, 7)};
  } else {
    return {three.low, {__builtin_shufflevector(three.high.value, fourth.high.value, 0, 3)}};
  }
}

}  // namespace PENDULAR_REGISTERS
}  // namespace simd

namespace detail {
/// One row as a value.
using four = lanes<4>;
template <class Row>
four load_row(const Row& row) {
  return four(simd::read_row(row));
}
template <simd::FourDoubles Row>
void store_row(Row& row, const four& values) {
  values.store(reinterpret_cast<double*>(&row));
}
}  // namespace detail

namespace simd {
inline namespace PENDULAR_REGISTERS {

/// The rows of a block of indices as lanes: eight loads and a few shuffles instead of a load and an insertion for each
/// of the 32 numbers. A row is a quad or any other four numbers.
template <class Row>
quad_block gather(const Row* column, const std::int32_t* rows) {
  const auto two = [&](int k) { return joined(read_row(column[rows[k]]), read_row(column[rows[k + 4]])); };
  registers<double, 8> a = two(0), b = two(1), c = two(2), d = two(3);
  transpose_both(a, b, c, d);
  return {block(a), block(b), block(c), block(d)};
}

/// The opposite: lanes become eight rows, of which row(k) is number k.
template <class Row>
[[gnu::always_inline]] inline void scatter(const quad_block& values, const Row& row) {
  registers<double, 8> a = values.a.parts, b = values.b.parts, c = values.c.parts, d = values.d.parts;
  transpose_both(a, b, c, d);
  const auto write_two = [&](int k, const registers<double, 8>& two) {
    write_row(row(k), low_half(two));
    write_row(row(k + 4), high_half(two));
  };
  write_two(0, a), write_two(1, b), write_two(2, c), write_two(3, d);
}

/// Lanes become eight rows that follow each other.
inline void store(quad* rows, const quad_block& values) {
  scatter(values, [&](int k) -> quad& { return rows[k]; });
}
inline void store(octet* rows, const quad_block& low, const quad_block& high) {
  scatter(low, [&](int k) -> quad& { return rows[k].low; });
  scatter(high, [&](int k) -> quad& { return rows[k].high; });
}

}  // namespace PENDULAR_REGISTERS
}  // namespace simd

using simd::gather;
using simd::quad_block;
using simd::store;

}  // namespace pendular
