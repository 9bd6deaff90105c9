// SPDX-License-Identifier: BSD-3-Clause
// expect 1: the caught one
// expect 2: the harmless one
#if PENDULAR_MISTAKE == 1
static_assert(false, "the caught one");
#endif
