// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
template <std::size_t N>
struct tower : tower<N - 1> {};
template <>
struct tower<0> {};
inline tower<200> two_hundred;
