// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/pendular.hpp>

int from_a() { return 1; }
