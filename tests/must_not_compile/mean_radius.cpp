// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a mean radius must be copyable
// expect 2: a mean radius needs `template <Scalar T> T of(const bridge<T>&) const`
// expect 3: of must return the scalar type of its bridge
// expect 4: a mean radius must take every scalar, not double alone
// expect 5: of must return the scalar type of its bridge: write T
// expect 6: capillary::richefeu_with takes a mean radius, such as mean_radius::harmonic
#include <pendular/law/capillary/richefeu_with.hpp>
#include <pendular/law/check.hpp>
#include <pendular/law/rupture/lian.hpp>

using namespace pendular;

struct my_mean {
#if PENDULAR_MISTAKE == 1
  my_mean(const my_mean&) = delete;
#endif
#if PENDULAR_MISTAKE == 2
  template <Scalar T>
  T of(const T& radius_i, const T& radius_j) const {
    return T(0.5) * (radius_i + radius_j);
  }
#elif PENDULAR_MISTAKE == 3
  template <Scalar T>
  bridge<T> of(const bridge<T>& b) const {
    return b;
  }
#elif PENDULAR_MISTAKE == 4
  double of(const bridge<double>& b) const { return 0.5 * (b.radius_i + b.radius_j); }
#elif PENDULAR_MISTAKE == 5
  template <Scalar T>
  auto of(const bridge<T>& b) const {
    return T(0.5) * (b.radius_i + b.radius_j);
  }
#else
  template <Scalar T>
  T of(const bridge<T>& b) const {
    return T(0.5) * (b.radius_i + b.radius_j);
  }
#endif
};
static_assert(check::mean_radius<my_mean>);

#if PENDULAR_MISTAKE == 6
const capillary::richefeu_with<rupture::lian> law{};
#else
const capillary::richefeu_with<my_mean> law{};
#endif
