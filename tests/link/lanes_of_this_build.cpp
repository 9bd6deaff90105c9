// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.hpp"

double sum_in_this_build(const double* numbers) { return sum_of(numbers); }
