// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>

#include <cstdint>
#include <cstring>

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

/// The same of a block of rows, number by number.
struct quad_block {
  block a, b, c, d;
};

namespace detail {
// The vector extension of GNU and clang; of which width the machine's registers are is the compiler's business. Passed by
// reference only, because by value the width decides about the calling convention.
using four_doubles = double __attribute__((vector_size(32)));
using eight_doubles = double __attribute__((vector_size(64)));

// As it lies in memory; g++ 12 takes a copy by memcpy through the stack where it is not merged with another.
using four_doubles_there [[gnu::may_alias]] = four_doubles;

template <class Row>
void read(four_doubles& to, const Row& row) {
  static_assert(sizeof(Row) == sizeof(quad) && alignof(Row) == alignof(quad));
  to = *reinterpret_cast<const four_doubles_there*>(&row);
}
template <class Row>
void write(const four_doubles& from, Row& row) {
  static_assert(sizeof(Row) == sizeof(quad) && alignof(Row) == alignof(quad));
  *reinterpret_cast<four_doubles_there*>(&row) = from;
}
inline void read(eight_doubles& to, const block& values) { std::memcpy(&to, values.data(), sizeof to); }
inline void write(const eight_doubles& from, block& values) { std::memcpy(values.data(), &from, sizeof from); }
template <class Row>
void read(eight_doubles& to, const Row& low, const Row& high) {
  static_assert(sizeof(Row) == sizeof(quad) && alignof(Row) == alignof(quad));
  four_doubles first, second;
  std::memcpy(&first, &low, sizeof first);
  std::memcpy(&second, &high, sizeof second);
  to = __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
}
inline void write(const eight_doubles& from, quad& low, quad& high) {
  const four_doubles first = __builtin_shufflevector(from, from, 0, 1, 2, 3);
  const four_doubles second = __builtin_shufflevector(from, from, 4, 5, 6, 7);
  std::memcpy(&low, &first, sizeof first);
  std::memcpy(&high, &second, sizeof second);
}

/// Each half of the four is a matrix of four by four; both are transposed.
inline void transpose(eight_doubles& a, eight_doubles& b, eight_doubles& c, eight_doubles& d) {
  const eight_doubles ab_even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
  const eight_doubles ab_odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  const eight_doubles cd_even = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
  const eight_doubles cd_odd = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 8, 9, 4, 5, 12, 13);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 8, 9, 4, 5, 12, 13);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 10, 11, 6, 7, 14, 15);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 10, 11, 6, 7, 14, 15);
}
}  // namespace detail

/// The rows of a block of indices as lanes: eight loads and eight shuffles instead of a load and an insertion for each
/// of the 32 numbers. A row is a quad or any other four numbers.
template <class Row>
quad_block gather(const Row* column, const std::int32_t* rows) {
  detail::eight_doubles a, b, c, d;
  detail::read(a, column[rows[0]], column[rows[4]]);
  detail::read(b, column[rows[1]], column[rows[5]]);
  detail::read(c, column[rows[2]], column[rows[6]]);
  detail::read(d, column[rows[3]], column[rows[7]]);
  detail::transpose(a, b, c, d);
  quad_block result;
  detail::write(a, result.a);
  detail::write(b, result.b);
  detail::write(c, result.c);
  detail::write(d, result.d);
  return result;
}

/// The opposite: lanes become eight rows that follow each other.
inline void store(quad* rows, const quad_block& values) {
  detail::eight_doubles a, b, c, d;
  detail::read(a, values.a);
  detail::read(b, values.b);
  detail::read(c, values.c);
  detail::read(d, values.d);
  detail::transpose(a, b, c, d);
  detail::write(a, rows[0], rows[4]);
  detail::write(b, rows[1], rows[5]);
  detail::write(c, rows[2], rows[6]);
  detail::write(d, rows[3], rows[7]);
}

/// The same for one half of rows of eight.
template <quad octet::*Half>
void store(octet* rows, const quad_block& values) {
  detail::eight_doubles a, b, c, d;
  detail::read(a, values.a), detail::read(b, values.b), detail::read(c, values.c), detail::read(d, values.d);
  detail::transpose(a, b, c, d);
  detail::write(a, rows[0].*Half, rows[4].*Half);
  detail::write(b, rows[1].*Half, rows[5].*Half);
  detail::write(c, rows[2].*Half, rows[6].*Half);
  detail::write(d, rows[3].*Half, rows[7].*Half);
}
inline void store(octet* rows, const quad_block& low, const quad_block& high) {
  store<&octet::low>(rows, low);
  store<&octet::high>(rows, high);
}

}  // namespace pendular
