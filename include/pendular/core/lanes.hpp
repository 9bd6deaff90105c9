// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lane_registers.hpp>
#include <pendular/core/vec.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>

// Inlines all that a function calls, where that is what its speed stands on. Not under sanitizers, whose checks make
// such a function too long to compile.
#if defined(__SANITIZE_ADDRESS__)
#define PENDULAR_FLATTEN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PENDULAR_FLATTEN
#endif
#endif
#ifndef PENDULAR_FLATTEN
#define PENDULAR_FLATTEN [[gnu::flatten]]
#endif

namespace pendular {

// A namespace of its own, where `sqrt(x)` of lanes is found by its argument: in pendular that name is an object.
namespace simd {
inline namespace PENDULAR_REGISTERS {

template <class A>
concept Number = std::is_arithmetic_v<A>;

template <class T>
inline constexpr bool never = false;

/// True or false, lane by lane: what a comparison of lanes answers.
template <int W, class E = double>
struct lane_mask {
  using truth = truth_of<E>;
  registers<truth, W> bits;  // -1 for true, 0 for false

  lane_mask() = default;
  lane_mask(const registers<truth, W>& r) : bits(r) {}

  bool operator[](int k) const { return element_at(bits, k) != 0; }

  friend lane_mask operator&&(const lane_mask& a, const lane_mask& b) {
    return {map<truth>(std::bit_and<>{}, a.bits, b.bits)};
  }
  friend lane_mask operator||(const lane_mask& a, const lane_mask& b) {
    return {map<truth>(std::bit_or<>{}, a.bits, b.bits)};
  }
  friend lane_mask operator!(const lane_mask& a) { return {map<truth>(std::bit_not<>{}, a.bits)}; }
  friend bool any(const lane_mask& m) { return any_true_in(m.bits); }
  friend bool all(const lane_mask& m) { return !any_true_in((!m).bits); }

  // A concept takes a mask for a bool therefore; the sentence is worth it.
  template <std::same_as<bool> B>
  operator B() const {
    static_assert(never<B>,
                  "a comparison of lanes has an answer for each of them, which `if`, `while`, `?:`, std::max and "
                  "std::min cannot take: write select(condition, a, b), max or min (docs/reference/concepts.md)");
    return false;
  }
};

/// W numbers side by side, the same value type in every build: no expression templates, and comparisons to choose by.
template <int W, class E = double>
struct lanes {
  static_assert(W >= 2 && std::has_single_bit(static_cast<unsigned>(W)), "the number of lanes is a power of two");
  static_assert(std::same_as<E, double> || std::same_as<E, float>, "lanes are of double or of float");

  using lane_element = E;
  using mask = lane_mask<W, E>;
  static constexpr int width = W;

  registers<E, W> parts;

  lanes() = default;
  explicit lanes(const registers<E, W>& r) : parts(r) {}
  template <Number A>
  explicit lanes(A value) : parts(filled_with<E, W>(static_cast<E>(value))) {}

  static lanes load(const E* from) { return lanes(read_from<E, W>(from)); }
  void store(E* to) const { write_to(to, parts); }

  /// make(k) for every lane k.
  template <class Make>
  static lanes from(const Make& make) {
    E values[W];
    for (int k = 0; k < W; ++k) values[k] = static_cast<E>(make(k));
    return load(values);
  }

  E operator[](int k) const { return element_at(parts, k); }
  void set(int k, E value) {
    const lanes before = *this;
    *this = from([&](int lane) { return lane == k ? value : before[lane]; });
  }

  friend lanes operator-(const lanes& a) { return each(std::negate<>{}, a); }
  friend lanes operator+(const lanes& a, const lanes& b) { return each(std::plus<>{}, a, b); }
  friend lanes operator-(const lanes& a, const lanes& b) { return each(std::minus<>{}, a, b); }
  friend lanes operator*(const lanes& a, const lanes& b) { return each(std::multiplies<>{}, a, b); }
  friend lanes operator/(const lanes& a, const lanes& b) { return each(std::divides<>{}, a, b); }
  lanes& operator+=(const lanes& b) { return *this = *this + b; }
  lanes& operator-=(const lanes& b) { return *this = *this - b; }
  lanes& operator*=(const lanes& b) { return *this = *this * b; }
  lanes& operator/=(const lanes& b) { return *this = *this / b; }
  template <Number A>
  lanes& operator+=(A b) {
    return *this = *this + lanes(b);
  }
  template <Number A>
  lanes& operator-=(A b) {
    return *this = *this - lanes(b);
  }
  template <Number A>
  lanes& operator*=(A b) {
    return *this = *this * lanes(b);
  }
  template <Number A>
  lanes& operator/=(A b) {
    return *this = *this / lanes(b);
  }

  friend mask operator<(const lanes& a, const lanes& b) { return compared(std::less<>{}, a, b); }
  friend mask operator>(const lanes& a, const lanes& b) { return compared(std::greater<>{}, a, b); }
  friend mask operator<=(const lanes& a, const lanes& b) { return compared(std::less_equal<>{}, a, b); }
  friend mask operator>=(const lanes& a, const lanes& b) { return compared(std::greater_equal<>{}, a, b); }
  friend mask operator==(const lanes& a, const lanes& b) { return compared(std::equal_to<>{}, a, b); }
  friend mask operator!=(const lanes& a, const lanes& b) { return compared(std::not_equal_to<>{}, a, b); }

  friend lanes sqrt(const lanes& a) {
    return each([](const auto& x) { return square_root(x); }, a);
  }
  /// The larger, lane by lane; what is no number in a stays.
  friend lanes max(const lanes& a, const lanes& b) {
    return each([](const auto& x, const auto& y) { return larger(x, y); }, a, b);
  }
  friend lanes min(const lanes& a, const lanes& b) {
    return each([](const auto& x, const auto& y) { return smaller(x, y); }, a, b);
  }
  friend lanes abs(const lanes& a) {
    return each([]<class V>(const V& x) { return absolute(x); }, a);
  }
  /// a where the condition holds, else b.
  friend lanes select(const mask& condition, const lanes& a, const lanes& b) {
    return lanes(map<E>([](const auto& m, const auto& x, const auto& y) { return m ? x : y; }, condition.bits, a.parts,
                        b.parts));
  }

  template <std::same_as<double> D>
  operator D() const {
    static_assert(never<D>,
                  "lanes are several numbers, of which none is the value: std::sqrt and the like take one number, "
                  "write pendular::sqrt, exp, max and so on (docs/reference/concepts.md)");
    return 0;
  }

  template <class F, class... Lanes>
  [[gnu::always_inline]] static lanes each(const F& f, const Lanes&... a) {
    return lanes(map<E>(f, a.parts...));
  }

 private:
  template <class F>
  [[gnu::always_inline]] static mask compared(const F& f, const lanes& a, const lanes& b) {
    return {map<truth_of<E>>(f, a.parts, b.parts)};
  }
};

template <class A>
concept Lanes = requires {
  typename A::lane_element;
};

template <Lanes T, Number A>
T operator+(const T& a, A b) {
  return a + T(b);
}
template <Lanes T, Number A>
T operator-(const T& a, A b) {
  return a - T(b);
}
template <Lanes T, Number A>
T operator*(const T& a, A b) {
  return a * T(b);
}
template <Lanes T, Number A>
T operator/(const T& a, A b) {
  return a / T(b);
}
template <Lanes T, Number A>
T operator+(A a, const T& b) {
  return T(a) + b;
}
template <Lanes T, Number A>
T operator-(A a, const T& b) {
  return T(a) - b;
}
template <Lanes T, Number A>
T operator*(A a, const T& b) {
  return T(a) * b;
}
template <Lanes T, Number A>
T operator/(A a, const T& b) {
  return T(a) / b;
}
template <Lanes T, Number A>
typename T::mask operator<(const T& a, A b) {
  return a < T(b);
}
template <Lanes T, Number A>
typename T::mask operator>(const T& a, A b) {
  return a > T(b);
}
template <Lanes T, Number A>
typename T::mask operator<=(const T& a, A b) {
  return a <= T(b);
}
template <Lanes T, Number A>
typename T::mask operator>=(const T& a, A b) {
  return a >= T(b);
}
template <Lanes T, Number A>
typename T::mask operator==(const T& a, A b) {
  return a == T(b);
}
template <Lanes T, Number A>
typename T::mask operator!=(const T& a, A b) {
  return a != T(b);
}
template <Lanes T, Number A>
typename T::mask operator==(A a, const T& b) {
  return T(a) == b;
}
template <Lanes T, Number A>
typename T::mask operator!=(A a, const T& b) {
  return T(a) != b;
}
template <Lanes T, Number A>
typename T::mask operator<=(A a, const T& b) {
  return T(a) <= b;
}
template <Lanes T, Number A>
typename T::mask operator>=(A a, const T& b) {
  return T(a) >= b;
}
template <Lanes T, Number A>
typename T::mask operator<(A a, const T& b) {
  return T(a) < b;
}
template <Lanes T, Number A>
typename T::mask operator>(A a, const T& b) {
  return T(a) > b;
}

/// Of all lanes, in an order that does not depend on the width of registers: halves are folded onto halves.
template <int W, class E>
E sum(const lanes<W, E>& a) {
  E values[W];
  a.store(values);
  for (int half = W / 2; half > 0; half /= 2) {
    for (int k = 0; k < half; ++k) values[k] += values[k + half];
  }
  return values[0];
}

}  // namespace PENDULAR_REGISTERS
}  // namespace simd

/// W scalars at a time: one SIMD register or a few, whatever the machine has.
using simd::lanes;

/// Pairs are evaluated this many at a time. Fixed, so that results do not depend on the machine's register width.
inline constexpr int lane_count = 8;
using block = lanes<lane_count>;

/// A number of rows rounded up to whole blocks.
constexpr std::size_t padded(std::size_t rows) {
  constexpr auto width = static_cast<std::size_t>(lane_count);
  return (rows + width - 1) / width * width;
}

namespace simd {
inline namespace PENDULAR_REGISTERS {
inline block load(const double* from) { return block::load(from); }
inline void store(double* to, const block& values) { values.store(to); }
}  // namespace PENDULAR_REGISTERS
}  // namespace simd
using simd::load;
using simd::store;

}  // namespace pendular

/// So that a law may write std::numeric_limits<T>::infinity().
template <int W, class E>
class std::numeric_limits<pendular::lanes<W, E>> : public std::numeric_limits<E> {
  using number = std::numeric_limits<E>;
  using lanes = pendular::lanes<W, E>;

 public:
  static lanes min() { return lanes(number::min()); }
  static lanes max() { return lanes(number::max()); }
  static lanes lowest() { return lanes(number::lowest()); }
  static lanes epsilon() { return lanes(number::epsilon()); }
  static lanes infinity() { return lanes(number::infinity()); }
  static lanes quiet_NaN() { return lanes(number::quiet_NaN()); }
};

#include <pendular/core/lane_maths.hpp>
