// SPDX-License-Identifier: BSD-3-Clause
// expect 1: lanes are several numbers, of which none is the value
// expect 2: a comparison of lanes has an answer for each of them
// expect 3: a comparison of lanes has an answer for each of them
// expect 4: lanes are several numbers, of which none is the value
// expect 5: the number of lanes is a power of two
// expect 6: lanes are of double or of float
// expect 7: pendular and the standard library use the names min and max: define NOMINMAX
// expect 8: pendular: -ffast-math (-ffinite-math-only, -Ofast) lets NaN pass every check
#include <algorithm>
#include <cmath>

#if PENDULAR_MISTAKE == 7
#define max(a, b) ((a) > (b) ? (a) : (b))
#elif PENDULAR_MISTAKE == 8
#define __FAST_MATH__ 1
#endif
#include <pendular/core/lanes.hpp>
#include <pendular/law/inputs.hpp>

using namespace pendular;

struct my_law {
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = max(T(-a.gap), T(0));
#if PENDULAR_MISTAKE == 1
    return overlap * std::sqrt(a.radius_i);
#elif PENDULAR_MISTAKE == 2
    if (a.gap > T(0)) return T(0);
    return overlap;
#elif PENDULAR_MISTAKE == 3
    return std::max(overlap, a.gap);
#elif PENDULAR_MISTAKE == 4
    const double one = overlap;
    return T(one);
#else
    return overlap * pendular::sqrt(a.radius_i) * pendular::select(a.gap > T(0), T(0), T(1));
#endif
  }
};

#if PENDULAR_MISTAKE == 5
using six = lanes<6>;
const six none_of_these(0.0);
#elif PENDULAR_MISTAKE == 6
const lanes<8, int> none_of_these(0);
#endif

block hot_loop(const approach<block>& a) { return my_law{}.repulsion(a); }
