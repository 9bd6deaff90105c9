// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(min) || defined(max)
#error                                                                                                                 \
    "pendular and the standard library use the names min and max: define NOMINMAX before <windows.h>, or #undef the macros (docs/how-to/cmake.md)"
#endif

#if (defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ + 0) && !defined(PENDULAR_ALLOW_FAST_MATH)
#error                                                                                                                 \
    "pendular: -ffast-math (-ffinite-math-only, -Ofast) lets NaN pass every check: build without, or define PENDULAR_ALLOW_FAST_MATH (docs/how-to/cmake.md)"
#endif

#include <cmath>
#include <concepts>
#include <type_traits>

namespace pendular {

/// A number a law can be written in: double, float, lanes of them, an AutoDiffScalar, a multiprecision float. Needs + - * / and construction from double; the functions below supply the rest.
template <class T>
concept Scalar = std::copy_constructible<T> && std::constructible_from<T, double> && requires(const T a, const T b) {
  T(a + b);
  T(a - b);
  T(a * b);
  T(a / b);
  T(-a);
};

namespace detail {
/// Several numbers side by side, which have an answer each to a comparison (core/lanes.hpp).
template <class T>
concept Lanes = requires {
  typename std::remove_cvref_t<T>::lane_element;
};

/// The element type behind lanes; the type itself for every other scalar.
template <class T>
struct element {
  using type = T;
};
template <Lanes T>
struct element<T> {
  using type = typename T::lane_element;
};
}  // namespace detail

template <class T>
using element_t = typename detail::element<std::remove_cvref_t<T>>::type;

// The vocabulary of law bodies. They are objects, not function templates, so that argument-dependent lookup never adds a
// second candidate. A law outside of namespace pendular writes pendular::sqrt(x): after `using namespace pendular` the
// bare name would be ambiguous with that of <math.h>.
namespace detail {
struct exp_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::exp;
    return exp(x);
  }
};
struct log_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::log;
    return log(x);
  }
};
struct sqrt_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::sqrt;
    return sqrt(x);
  }
};
struct abs_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::abs;
    return abs(x);
  }
};
struct cos_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::cos;
    return cos(x);
  }
};
struct sin_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::sin;
    return sin(x);
  }
};
struct pow_fn {
  template <class T, class P>
  auto operator()(const T& x, const P& exponent) const {
    using std::pow;
    if constexpr (std::is_arithmetic_v<P> && (std::is_floating_point_v<T> || Lanes<T>)) {
      return pow(x, static_cast<element_t<T>>(exponent));
    } else {
      return pow(x, exponent);
    }
  }
};
struct cbrt_fn {
  template <class T>
  auto operator()(const T& x) const {
    using std::cbrt;
    if constexpr (requires { cbrt(x); }) {
      return cbrt(x);
    } else {
      using std::pow;
      return pow(x, 1.0 / 3.0);
    }
  }
};
/// The larger of the two, a where one is no number.
struct max_fn {
  template <class T>
  T operator()(const T& a, const T& b) const {
    if constexpr (Lanes<T>) {
      return max(a, b);
    } else {
      return a < b ? b : a;
    }
  }
};
struct min_fn {
  template <class T>
  T operator()(const T& a, const T& b) const {
    if constexpr (Lanes<T>) {
      return min(a, b);
    } else {
      return b < a ? b : a;
    }
  }
};
/// a where the condition holds, else b; both are evaluated. The condition is a comparison, or a number that is asked
/// whether it is positive.
struct select_fn {
  template <class Condition, class T>
  T operator()(const Condition& condition, const T& a, const T& b) const {
    if constexpr (std::is_arithmetic_v<Condition> && !std::is_same_v<Condition, bool>) {
      return condition > 0 ? a : b;
    } else if constexpr (std::is_same_v<Condition, T>) {
      return (*this)(condition > T(0), a, b);
    } else if constexpr (Lanes<T> && !std::is_same_v<Condition, bool>) {
      return select(condition, a, b);
    } else {
      return condition ? a : b;
    }
  }
};
/// 1 where x > 0, else 0.
struct unit_step_fn {
  template <class T>
  T operator()(const T& x) const {
    return select_fn{}(x > T(0), T(1), T(0));
  }
};
}  // namespace detail

inline constexpr detail::exp_fn exp{};
inline constexpr detail::log_fn log{};
inline constexpr detail::sqrt_fn sqrt{};
inline constexpr detail::abs_fn abs{};
inline constexpr detail::cos_fn cos{};
inline constexpr detail::sin_fn sin{};
inline constexpr detail::pow_fn pow{};
inline constexpr detail::cbrt_fn cbrt{};
inline constexpr detail::max_fn max{};
inline constexpr detail::min_fn min{};
inline constexpr detail::unit_step_fn unit_step{};
inline constexpr detail::select_fn select{};

/// A divisor is never allowed below this, so that 0/0 becomes 0 in every scalar, float included.
inline constexpr double tiny = 1e-30;

}  // namespace pendular
