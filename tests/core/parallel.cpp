// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/parallel.hpp>

#include <array>
#include <cmath>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pendular;

namespace {
void use_threads([[maybe_unused]] int threads) {
#ifdef _OPENMP
  omp_set_num_threads(threads);
#endif
}

double sum_in_chunks(std::size_t count, std::size_t chunk) {
  std::vector<double> sums(chunk_count(count, chunk), 0.0);
  for_chunks(count, chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
    for (std::size_t k = begin; k < end; ++k) sums[c] += 1 / std::sqrt(static_cast<double>(k) + 0.1);
  });
  double total = 0;
  for (const double s : sums) total += s;
  return total;
}
}  // namespace

TEST_CASE("chunks cover every index once, are full but the last and are numbered in order") {
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 64u, 1000u}) {
    std::vector<int> seen(count, 0);
    std::vector<std::array<std::size_t, 2>> limits(chunk_count(count, 8));
    for_chunks(count, 8, [&](std::size_t begin, std::size_t end, std::size_t c) {
      limits[c] = {begin, end};
      for (std::size_t k = begin; k < end; ++k) ++seen[k];
    });
    CHECK(seen == std::vector<int>(count, 1));
    for (std::size_t c = 0; c < limits.size(); ++c) {
      CHECK(limits[c][0] == 8 * c);
      CHECK(limits[c][1] == (c + 1 < limits.size() ? 8 * (c + 1) : count));
    }
  }
}

TEST_CASE("the number of chunks is the number of times the body runs") {
  CHECK(chunk_count(0, 8) == 0);
  CHECK(chunk_count(1, 8) == 1);
  CHECK(chunk_count(8, 8) == 1);
  CHECK(chunk_count(9, 8) == 2);
}

TEST_CASE("a sum kept per chunk is the same to the last bit for any number of threads") {
  use_threads(1);
  const double alone = sum_in_chunks(100000, 512);
  for (const int threads : {2, 3, 8}) {
    use_threads(threads);
    for (int again = 0; again < 5; ++again) CHECK(sum_in_chunks(100000, 512) == alone);
  }
  use_threads(2);
}
