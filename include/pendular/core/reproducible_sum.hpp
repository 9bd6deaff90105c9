// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace pendular {

/// A sum of doubles that is exact, hence the same in any order, in any number of parts that are joined, on any number of
/// threads or ranks; rounded once, to nearest, where its value is asked. Some nanoseconds per number, 0.5 kB.
/// Valid for finite numbers whose sum is finite, at most 2^60 of them; one that is not finite makes the value no number.
/// Source: R. M. Neal 2015, Fast exact summation using small and large superaccumulators, arXiv:1505.05571, section 2.
class reproducible_sum {
 public:
  void add(double v) {
    const auto bits = std::bit_cast<std::uint64_t>(v);
    const auto exponent = static_cast<unsigned>(bits >> 52) & 0x7ffu;
    if (exponent == 0x7ffu) {
      finite_ = false;
      return;
    }
    const std::uint64_t fraction = bits & 0xfffffffffffffu;
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | 0x10000000000000u;
    const unsigned place = exponent == 0 ? 0 : exponent - 1;  // of the lowest bit, above 2^-1074
    put(mantissa, place, (bits >> 63) != 0);
    if (++adds_ == most_adds) carry();
  }

  void join(const reproducible_sum& other) {
    reproducible_sum tidy = other;
    tidy.carry();
    carry();
    for (std::size_t k = 0; k < digits; ++k) digit_[k] += tidy.digit_[k];
    finite_ = finite_ && other.finite_;
    carry();
  }

  /// Correctly rounded.
  double value() const {
    if (!finite_) return std::numeric_limits<double>::quiet_NaN();
    reproducible_sum tidy = *this;
    tidy.carry();
    const bool negative = tidy.digit_[digits - 1] < 0;
    if (negative) {
      for (auto& d : tidy.digit_) d = -d;
      tidy.carry();
    }
    const double size = tidy.rounded();
    return negative ? -size : size;
  }

 private:
  // Digits of 32 bits in numbers of 64, so that carries can wait: digit k counts 2^(32 k - 1074).
  static constexpr std::size_t digits = 68;
  static constexpr std::int64_t most_adds = std::int64_t{1} << 30;

  void put(std::uint64_t mantissa, unsigned place, bool negative) {
    const unsigned first = place / 32, shift = place % 32;
    const std::uint64_t low = mantissa << shift;                           // bits 0 to 63
    const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);  // and what is beyond
    const std::int64_t sign = negative ? -1 : 1;
    digit_[first] += sign * static_cast<std::int64_t>(low & 0xffffffffu);
    digit_[first + 1] += sign * static_cast<std::int64_t>(low >> 32);
    digit_[first + 2] += sign * static_cast<std::int64_t>(high);
  }

  /// All digits but the last into 0 .. 2^32 - 1.
  void carry() {
    for (std::size_t k = 0; k + 1 < digits; ++k) {
      const std::int64_t over = digit_[k] >> 32;  // towards minus infinity
      digit_[k] -= over * (std::int64_t{1} << 32);
      digit_[k + 1] += over;
    }
    adds_ = 0;
  }

  /// Of digits that are tidy and not negative: to nearest, ties to even.
  double rounded() const {
    std::size_t top = digits;
    while (top > 0 && digit_[top - 1] == 0) --top;
    if (top == 0) return 0;
    const auto width = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(digit_[top - 1])));
    const int highest = 32 * static_cast<int>(top - 1) + width - 1;  // place of the highest bit
    const int lowest = highest > 52 ? highest - 52 : 0;              // of the last one that a double keeps
    std::uint64_t mantissa = bits_from(lowest);
    const bool half = lowest > 0 && bit(lowest - 1), more = lowest > 1 && any_below(lowest - 1);
    if (half && (more || (mantissa & 1) != 0)) ++mantissa;
    return std::ldexp(static_cast<double>(mantissa), lowest - 1074);
  }
  bool bit(int place) const { return ((digit_[static_cast<std::size_t>(place / 32)] >> (place % 32)) & 1) != 0; }
  bool any_below(int place) const {
    for (int k = 0; k < place / 32; ++k) {
      if (digit_[static_cast<std::size_t>(k)] != 0) return true;
    }
    const std::int64_t mask = (std::int64_t{1} << (place % 32)) - 1;
    return (digit_[static_cast<std::size_t>(place / 32)] & mask) != 0;
  }
  /// The 53 bits from a place on.
  std::uint64_t bits_from(int place) const {
    std::uint64_t found = 0;
    for (int k = 0; k < 53; ++k) {
      if (static_cast<std::size_t>((place + k) / 32) < digits && bit(place + k)) found |= std::uint64_t{1} << k;
    }
    return found;
  }

  std::array<std::int64_t, digits> digit_{};
  std::int64_t adds_ = 0;
  bool finite_ = true;
};

}  // namespace pendular
