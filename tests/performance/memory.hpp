// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <malloc.h>

/// Bytes that the process holds.
inline double memory() {
  const auto now = mallinfo2();
  return static_cast<double>(now.uordblks) + static_cast<double>(now.hblkhd);
}
