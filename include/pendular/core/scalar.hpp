// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <concepts>
#include <type_traits>

namespace pendular {

/// A number a law can be written in: double, float, a fixed Eigen array (lanes), an AutoDiffScalar, a multiprecision
/// float. Needs + - * / and construction from double; the functions below supply the rest.
template <class T>
concept Scalar = std::copy_constructible<T> && std::constructible_from<T, double> && requires(const T a, const T b) {
  T(a + b);
  T(a - b);
  T(a * b);
  T(a / b);
  T(-a);
};

namespace detail {
// An array inherits the name of its base. That is all there is to ask, so that a law's header comes without Eigen.
template <class T>
concept EigenArray = requires {
  typename std::remove_cvref_t<T>::ArrayBase;
};

/// The element type behind lanes; the type itself for every other scalar.
template <class T>
struct element {
  using type = T;
};
template <EigenArray T>
struct element<T> {
  using type = typename T::Scalar;
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
    if constexpr (std::is_arithmetic_v<P> && (std::is_floating_point_v<T> || EigenArray<T>)) {
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
    if constexpr (EigenArray<T>) {
      return x.unaryExpr([](const element_t<T> v) { return std::cbrt(v); });
    } else if constexpr (requires { cbrt(x); }) {
      return cbrt(x);
    } else {
      using std::pow;
      return pow(x, 1.0 / 3.0);
    }
  }
};
struct max_fn {
  template <class T>
  auto operator()(const T& a, const T& b) const {
    if constexpr (EigenArray<T>) {
      return a.max(b);
    } else {
      return T(a < b ? b : a);
    }
  }
};
struct min_fn {
  template <class T>
  auto operator()(const T& a, const T& b) const {
    if constexpr (EigenArray<T>) {
      return a.min(b);
    } else {
      return T(b < a ? b : a);
    }
  }
};
/// 1 where x > 0, else 0. Lanes multiply instead of comparing, because Eigen 3.4 does not vectorise comparisons; a
/// positive x below 1e-300 (1e-30 in float) then counts as a fraction of 1.
struct unit_step_fn {
  template <class T>
  T operator()(const T& x) const {
    if constexpr (EigenArray<T>) {
      using element = element_t<T>;
      constexpr element steep = sizeof(element) >= 8 ? element(1e300) : element(1e30f);
      return (x * steep).max(element(0)).min(element(1));
    } else {
      return x > T(0) ? T(1) : T(0);
    }
  }
};
/// a where the condition is positive, else b; both are evaluated and must be finite.
struct select_fn {
  template <class T>
  T operator()(const T& condition, const T& a, const T& b) const {
    const T one_or_zero = unit_step_fn{}(condition);
    return one_or_zero * a + (T(1) - one_or_zero) * b;
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
