// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How a program ends that was built for instructions which this processor lacks.
inline constexpr int not_on_this_machine = 77;

/// Whether this processor has what the program was built for.
inline bool has_instructions_of_build() {
#if defined(__AVX512F__)
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
#elif defined(__AVX2__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}
