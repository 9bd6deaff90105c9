// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/fields.hpp>
#include <pendular/law/concepts.hpp>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <array>
#include <cstddef>
#include <type_traits>

namespace pendular {

/// A double that carries its derivative by one variable.
using dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

namespace detail {
inline dual variable(double value) { return dual(value, Eigen::Matrix<double, 1, 1>(1.0)); }
inline dual constant(double value) { return dual(value, Eigen::Matrix<double, 1, 1>(0.0)); }

inline approach<dual> varied(const approach<double>& a) {
  return {variable(a.gap), constant(a.closing_speed), constant(a.reduced_mass), constant(a.radius_i),
          constant(a.radius_j)};
}

template <class Law, class T>
concept KnowsStiffness = requires(const Law law, const approach<T> a) {
  { law.stiffness(a) } -> std::convertible_to<T>;
};
template <class Law, class T>
concept KnowsStiffnessNow = requires(const Law law, const approach<T> a, const contact_memory_t<Law, T>& memory) {
  requires Remembers<Law, T>;
  { law.stiffness(a, memory) } -> std::convertible_to<T>;
};

template <class Memory, class T>
Memory untouched() {
  Memory memory{};
  for_each_scalar<T>(memory, [](T& x) { x = T(0); });
  return memory;
}

/// The same memory in another scalar: value(scalar) for each of its numbers.
template <class To, class From, class Memory, class Source, class Value>
Memory converted(const Source& source, const Value& value) {
  constexpr std::size_t count = scalar_count<From, Source>;
  std::array<double, count> numbers;
  std::size_t k = 0;
  for_each_scalar<From>(source, [&](const From& x) { numbers[k++] = value(x); });
  Memory memory{};
  k = 0;
  for_each_scalar<To>(memory, [&](To& x) { x = To(numbers[k++]); });
  return memory;
}

/// Of a law that remembers, in double, by automatic differentiation of a push whose memory is thrown away.
template <class Law>
double differentiated(const Law& law, const approach<double>& a, const contact_memory_t<Law, double>& memory) {
  contact_memory_t<Law, dual> own =
      converted<dual, double, contact_memory_t<Law, dual>>(memory, [](double x) { return x; });
  for_each_scalar<dual>(own, [](dual& x) { x = constant(x.value()); });
  const dual force = law.repulsion(varied(a), own);
  return -force.derivatives()(0);
}
}  // namespace detail

/// -d(repulsion)/d(gap), N/m, of a normal law that remembers, at a contact: its own `stiffness(approach, memory)` where
/// it has one, else by automatic differentiation, lane by lane. The memory stays as it is.
template <NormalLaw Law, Scalar T>
T stiffness(const Law& law, const approach<T>& a, const contact_memory_t<Law, T>& memory) {
  if constexpr (detail::KnowsStiffnessNow<Law, T>) {
    return law.stiffness(a, memory);
  } else if constexpr (std::is_arithmetic_v<T>) {
    const contact_memory_t<Law, double> own =
        detail::converted<double, T, contact_memory_t<Law, double>>(memory, [](T x) { return double(x); });
    return static_cast<T>(detail::differentiated(
        law, approach<double>{a.gap, a.closing_speed, a.reduced_mass, a.radius_i, a.radius_j}, own));
  } else {
    return T::from([&](int k) {
      const approach<double> one{a.gap[k], a.closing_speed[k], a.reduced_mass[k], a.radius_i[k], a.radius_j[k]};
      const contact_memory_t<Law, double> own =
          detail::converted<double, T, contact_memory_t<Law, double>>(memory, [k](const T& x) { return double(x[k]); });
      return detail::differentiated(law, one, own);
    });
  }
}

/// -d(repulsion)/d(gap), N/m, of any normal law: its own `stiffness(approach)` where it has one, else by automatic
/// differentiation, lane by lane; of a law that remembers at first touch.
template <NormalLaw Law, Scalar T>
T stiffness(const Law& law, const approach<T>& a) {
  if constexpr (detail::KnowsStiffness<Law, T>) {
    return law.stiffness(a);
  } else if constexpr (detail::Remembers<Law, T>) {
    return stiffness(law, a, detail::untouched<contact_memory_t<Law, T>, T>());
  } else if constexpr (std::is_same_v<T, double>) {
    const dual force = law.repulsion(detail::varied(a));
    return -force.derivatives()(0);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return static_cast<T>(
        stiffness(law, approach<double>{a.gap, a.closing_speed, a.reduced_mass, a.radius_i, a.radius_j}));
  } else {
    return T::from([&](int k) {
      const approach<double> one{a.gap[k], a.closing_speed[k], a.reduced_mass[k], a.radius_i[k], a.radius_j[k]};
      return stiffness(law, one);
    });
  }
}

/// d(attraction)/d(gap), N/m, of any capillary law at the gap of b, by automatic differentiation.
template <CapillaryLaw Law>
double slope(const Law& law, const bridge<double>& b, const fluid& f) {
  using detail::constant;
  const bridge<dual> varied{detail::variable(b.gap), constant(b.volume), constant(b.radius_i), constant(b.radius_j)};
  if constexpr (detail::Attracts<Law, dual>) {
    const dual pull = law.attraction(varied, f);
    return pull.derivatives()(0);
  } else {
    const dual pull = law.attraction(varied.gap, law.prepare(varied, f));
    return pull.derivatives()(0);
  }
}

}  // namespace pendular
