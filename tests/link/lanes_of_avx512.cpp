// SPDX-License-Identifier: BSD-3-Clause
// Compiled for other registers than the rest of the program.
#include "lanes.hpp"

double sum_with_avx512(const double* numbers) { return sum_of(numbers); }
