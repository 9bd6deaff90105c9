// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

// Functions of lanes of double, to a few units in the last place (pow: see there) and to the same bits in every build:
// they are sums and products of lanes, and roots. The polynomials are interpolants at the Chebyshev nodes of the interval beside them, worked out
// with 60 digits. Lanes of float go number by number: they are for the tests of laws.
namespace pendular::simd {
inline namespace PENDULAR_REGISTERS {

namespace detail {
template <int W, class E, class F>
lanes<W, E> one_by_one(const F& f, const lanes<W, E>& x) {
  return lanes<W, E>::from([&](int k) { return f(x[k]); });
}

/// c0 + c1 x + c2 x^2 + ...
template <class T>
T polynomial(const T&, double c0) {
  return T(c0);
}
template <class T, class... More>
T polynomial(const T& x, double c0, More... more) {
  return T(c0) + x * polynomial(x, more...);
}

using bits = std::uint64_t;  // of a double
inline constexpr int fraction_bits = 52;

template <int W, class F>
registers<bits, W> bits_of(const lanes<W>& x, const F& f) {
  return map<bits>([&]<class V>(const V& v) { return f((vector_of<bits, sizeof(V) / sizeof(bits)>)v); }, x.parts);
}
template <int W>
lanes<W> of_bits(const registers<bits, W>& r) {
  return lanes<W>(map<double>([]<class V>(const V& v) { return (vector_of<double, sizeof(V) / sizeof(double)>)v; }, r));
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double shifter = 0x1.8p52;  // a sum with it has no fraction, and its whole part in the lowest bits
inline constexpr bits shifter_bits = std::bit_cast<bits>(shifter);
inline constexpr bits half_root_bits = std::bit_cast<bits>(std::numbers::sqrt2 / 2);
inline constexpr bits exponent_bias = 1023, one_exponent = exponent_bias << fraction_bits;
inline constexpr double ln2_high = 0x1.62e42fefa3800p-1, ln2_low = 5.497923018708371e-14;

/// x times 2^n; `shifted` is n + shifter.
template <int W>
lanes<W> times_power_of_two(const lanes<W>& x, const lanes<W>& shifted) {
  const auto power = bits_of(shifted, [](const auto& n) { return n << fraction_bits; });
  const auto sum = map<bits>([](const auto& a, const auto& b) { return a + b; }, bits_of(x, std::identity{}), power);
  return of_bits<W>(sum);
}
}  // namespace detail

/// e^x: 0 below -708.39, where less than the smallest normal number would be left, infinite above 709.78.
template <int W>
lanes<W> exp(const lanes<W>& x) {
  constexpr double least = -708.39, most = 709.78;
  const lanes<W> held = min(max(x, lanes<W>(least)), lanes<W>(most));
  const lanes<W> shifted = held * std::numbers::log2e + detail::shifter, n = shifted - detail::shifter;
  const lanes<W> r = (held - n * detail::ln2_high) - n * detail::ln2_low;
  // (e^r - 1 - r) / r^2 for |r| up to ln(2)/2, to 1e-16
  const lanes<W> q =
      detail::polynomial(r, 0.5000000000000001, 0.16666666666666669, 0.04166666666662413, 0.008333333333330062,
                         0.0013888888917213717, 0.00019841269863053618, 2.4801521295954376e-05, 2.7557268459997064e-06,
                         2.7620088445409746e-07, 2.510038549551032e-08);
  const lanes<W> result = detail::times_power_of_two(1.0 + (r + r * r * q), shifted);
  return select(x <= most, select(x < least, lanes<W>(0.0), result), x + detail::infinity);
}

/// Natural logarithm: minus infinity at 0, no number below.
template <int W>
lanes<W> log(const lanes<W>& x) {
  const auto denormal = x < std::numeric_limits<double>::min();
  const lanes<W> scaled = select(denormal, x * 0x1p54, x);
  // x is m 2^n with m from 1/sqrt 2 to sqrt 2: what its bits exceed those of 1/sqrt 2 by counts n
  const auto count = [](const auto& b) {
    return (b - detail::half_root_bits + detail::one_exponent) >> detail::fraction_bits;
  };
  const lanes<W> m = detail::of_bits<W>(detail::bits_of(
      scaled, [&](const auto& b) { return b - (count(b) << detail::fraction_bits) + detail::one_exponent; }));
  const lanes<W> shifted = detail::of_bits<W>(
      detail::bits_of(scaled, [&](const auto& b) { return count(b) + detail::shifter_bits - detail::exponent_bias; }));
  const lanes<W> n = shifted - detail::shifter - select(denormal, lanes<W>(54.0), lanes<W>(0.0));
  // ln(1 + f) = f - (f^2/2 - s (f^2/2 + R)), R = 2 atanh(s) / s - 2, s = f / (2 + f)
  const lanes<W> f = m - 1.0, s = f / (f + 2.0), z = s * s, half = 0.5 * f * f;
  // R / z for z up to ((sqrt 2 - 1) / (sqrt 2 + 1))^2, to 1e-17
  const lanes<W> series =
      z * detail::polynomial(z, 0.6666666666666666, 0.4000000000000088, 0.2857142857080323, 0.2222222239180047,
                             0.18181795630884753, 0.15386240205813478, 0.13268759668560612, 0.13086767009948175);
  const lanes<W> result = n * detail::ln2_high + (f - (half - (s * (half + series) + n * detail::ln2_low)));
  const lanes<W> above = select(x > 0.0, result, lanes<W>(detail::no_number));
  const lanes<W> finite = select(x == 0.0, lanes<W>(-detail::infinity), above);
  return select(x == detail::infinity, x, finite);
}

namespace detail {
/// |x|^p with the sign that std::pow gives it; `odd` and `whole` say what p is.
template <int W>
lanes<W> with_sign_of_power(const lanes<W>& size, const lanes<W>& x, bool whole, bool odd) {
  const auto below = x < 0.0 || 1.0 / x == -infinity;  // minus zero, too
  if (odd) return select(below, -size, size);
  return whole ? size : select(x < 0.0 && x > -infinity, lanes<W>(no_number), size);
}
}  // namespace detail

/// x to a power that all lanes share, with the limits and signs of std::pow: products, quotients and roots for small whole
/// numbers and halves, else e^(p ln |x|), to |p ln x| units in the last place; 0 instead of less than the smallest normal
/// number.
template <int W, Number P>
lanes<W> pow(const lanes<W>& x, P exponent) {
  const double p = static_cast<double>(exponent);
  if (p == 0) return lanes<W>(1.0);
  if (p == 1) return x;
  if (p == 2) return x * x;
  if (p == 3) return x * x * x;
  if (p == -1) return 1.0 / x;
  if (p == -2) return 1.0 / (x * x);
  const lanes<W> size = abs(x);
  if (p == 0.5) return detail::with_sign_of_power(sqrt(size), x, false, false);
  if (p == 1.5) return detail::with_sign_of_power(size * sqrt(size), x, false, false);
  const bool whole = std::trunc(p) == p, odd = std::abs(std::fmod(p, 2)) == 1;
  const lanes<W> power = select(size == 1.0, lanes<W>(1.0), exp(p * log(size)));
  return detail::with_sign_of_power(power, x, whole, odd);
}
/// Each lane to its own power, number by number.
template <int W>
lanes<W> pow(const lanes<W>& x, const lanes<W>& exponent) {
  return lanes<W>::from([&](int k) { return std::pow(x[k], exponent[k]); });
}
template <int W, Number A>
lanes<W> pow(A x, const lanes<W>& exponent) {
  return pow(lanes<W>(x), exponent);
}

/// Third root, negative below 0.
template <int W>
lanes<W> cbrt(const lanes<W>& x) {
  const lanes<W> size = abs(x);
  const auto is_small = size < 1e-280;  // whose cube would have too few digits
  const lanes<W> scaled = select(is_small, size * 0x1p300, size), guess = exp(log(scaled) / 3.0);
  const lanes<W> better = guess - (guess * guess * guess - scaled) / (3.0 * guess * guess);
  const lanes<W> root = select(is_small, better * 0x1p-100, better);
  return select(size > 0.0 && size < detail::infinity, select(x < 0.0, -root, root), x);
}

namespace detail {
/// sin and cos of x less the nearest quarter turn, and which of the four that is.
template <int W>
struct quarter {
  lanes<W> sine, cosine, turn;  // turn: -2, -1, 0, 1 or 2
};

inline constexpr double farthest_angle = 1e6;  // up to where the three parts of pi/2 are enough

template <int W>
quarter<W> quarter_of(const lanes<W>& x) {
  const lanes<W> n = (x * (2 / std::numbers::pi) + shifter) - shifter;
  const lanes<W> r = ((x - n * 0x1.921fb54400000p+0) - n * 0x1.0b4611a600000p-34) - n * 0x1.3198a2e037073p-69;
  const lanes<W> z = r * r;
  // (sin r - r) / r^3 and (cos r - 1 + r^2/2) / r^4 for r up to pi/4, to 2e-17
  const lanes<W> s = polynomial(z, -0.16666666666666666, 0.008333333333330936, -0.00019841269836740532,
                                2.7557316093198404e-06, -2.5051129896450185e-08, 1.5917988979397435e-10);
  const lanes<W> c = polynomial(z, 0.041666666666666664, -0.0013888888888887389, 2.48015872987544e-05,
                                -2.755731726587808e-07, 2.087614504941318e-09, -1.138254464534925e-11);
  return {r + r * z * s, 1.0 - (0.5 * z - z * z * c), n - 4.0 * ((0.25 * n + shifter) - shifter)};
}
}  // namespace detail

template <int W>
lanes<W> sin(const lanes<W>& x) {
  const auto q = detail::quarter_of(x);
  const lanes<W> size = select(abs(q.turn) == 1.0, q.cosine, q.sine);
  const lanes<W> reduced = select(x == 0.0, x, select(q.turn < 0.0 || q.turn > 1.0, -size, size));  // minus zero stays
  const auto is_far = abs(x) > detail::farthest_angle;
  return any(is_far) ? select(is_far, detail::one_by_one([](double v) { return std::sin(v); }, x), reduced) : reduced;
}

template <int W>
lanes<W> cos(const lanes<W>& x) {
  const auto q = detail::quarter_of(x);
  const lanes<W> size = select(abs(q.turn) == 1.0, q.sine, q.cosine);
  const lanes<W> reduced = select(abs(q.turn) > 1.0 || q.turn == 1.0, -size, size);
  const auto is_far = abs(x) > detail::farthest_angle;
  return any(is_far) ? select(is_far, detail::one_by_one([](double v) { return std::cos(v); }, x), reduced) : reduced;
}

template <int W>
using floats = lanes<W, float>;
template <int W>
floats<W> exp(const floats<W>& x) {
  return detail::one_by_one([](float v) { return std::exp(v); }, x);
}
template <int W>
floats<W> log(const floats<W>& x) {
  return detail::one_by_one([](float v) { return std::log(v); }, x);
}
template <int W, Number P>
floats<W> pow(const floats<W>& x, P exponent) {
  return detail::one_by_one([p = static_cast<float>(exponent)](float v) { return std::pow(v, p); }, x);
}
template <int W>
floats<W> pow(const floats<W>& x, const floats<W>& exponent) {
  return floats<W>::from([&](int k) { return std::pow(x[k], exponent[k]); });
}
template <int W, Number A>
floats<W> pow(A x, const floats<W>& exponent) {
  return pow(floats<W>(x), exponent);
}
template <int W>
floats<W> cbrt(const floats<W>& x) {
  return detail::one_by_one([](float v) { return std::cbrt(v); }, x);
}
template <int W>
floats<W> sin(const floats<W>& x) {
  return detail::one_by_one([](float v) { return std::sin(v); }, x);
}
template <int W>
floats<W> cos(const floats<W>& x) {
  return detail::one_by_one([](float v) { return std::cos(v); }, x);
}

}  // namespace PENDULAR_REGISTERS
}  // namespace pendular::simd
