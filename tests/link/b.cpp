// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/pendular.hpp>

int from_b() { return -1; }
