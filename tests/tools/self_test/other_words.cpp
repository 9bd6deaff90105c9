// SPDX-License-Identifier: BSD-3-Clause
// expect: the words we want
#ifdef PENDULAR_MISTAKE
static_assert(false, "some words");  // the words we want
#endif
