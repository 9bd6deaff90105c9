// SPDX-License-Identifier: BSD-3-Clause
// A function in a header that is neither inline nor a template is defined twice here and does not link.
int from_a();
int from_b();
double sum_in_this_build(const double* numbers);

int main() {
  const double numbers[] = {1, 2, 3, 4, 5, 6, 7, 8};
  bool right = sum_in_this_build(numbers) == 72;
#ifdef PENDULAR_WITH_AVX512
  // Its lanes are in other registers, which does not matter as long as no function is taken from there.
  double sum_with_avx512(const double* numbers);
  if (__builtin_cpu_supports("avx512f")) right = right && sum_with_avx512(numbers) == 72;
#endif
  return right ? from_a() + from_b() : 1;
}
