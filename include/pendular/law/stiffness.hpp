// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

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
}  // namespace detail

/// -d(repulsion)/d(gap), N/m, of any normal law: its own `stiffness(approach)` where it has one, else by automatic
/// differentiation, lane by lane.
template <NormalLaw Law, Scalar T>
T stiffness(const Law& law, const approach<T>& a) {
  if constexpr (detail::KnowsStiffness<Law, T>) {
    return law.stiffness(a);
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
