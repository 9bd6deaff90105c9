// SPDX-License-Identifier: BSD-3-Clause
// expect 1: remembered
#if PENDULAR_MISTAKE == 1
static_assert(false, "remembered");
#elif PENDULAR_MISTAKE == 2
static_assert(false, "forgotten");
#endif
