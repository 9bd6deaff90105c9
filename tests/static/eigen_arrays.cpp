// SPDX-License-Identifier: BSD-3-Clause
// The vocabulary of laws knows an Eigen array by a name, without Eigen's headers. Here Eigen says which is one.
#include <pendular/core/scalar.hpp>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <type_traits>

using pendular::detail::EigenArray;

namespace {

template <class Derived>
consteval bool is_array(const Eigen::ArrayBase<Derived>*) {
  return true;
}
consteval bool is_array(const void*) { return false; }

template <class T>
inline constexpr bool known = EigenArray<const T&>&& EigenArray<T>&& is_array(static_cast<T*>(nullptr));
template <class T>
inline constexpr bool refused = !is_array(static_cast<T*>(nullptr)) && !EigenArray<T> && !EigenArray<const T&>;

using doubles = Eigen::Array<double, 8, 1>;
constexpr auto twice = [](double x) { return 2 * x; };

static_assert(known<doubles> && known<Eigen::Array<float, 16, 1>> && known<Eigen::ArrayXXd>);
static_assert(known<Eigen::Map<const doubles>> && known<decltype(doubles().head<4>())>);
static_assert(known<decltype(doubles() * doubles())> && known<decltype(-doubles().max(0.0))>);
static_assert(known<decltype(doubles().unaryExpr(twice))> && known<decltype(Eigen::Matrix3d().array())>);
static_assert(refused<Eigen::Matrix3d> && refused<decltype(doubles().matrix())>);
static_assert(refused<Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>> && refused<double> && refused<float>);

}  // namespace
