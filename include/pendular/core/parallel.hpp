// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pendular {

/// body(begin, end, chunk) over [0, count) in chunks of a fixed size. Which thread runs a chunk never changes the
/// result, so a sum kept per chunk and added up in order is the same to the last bit for any number of threads.
template <class Body>
void for_chunks(std::size_t count, std::size_t chunk_size, const Body& body) {
  const auto chunks = static_cast<std::ptrdiff_t>((count + chunk_size - 1) / chunk_size);
  if (chunks == 1) {
    body(std::size_t{0}, count, std::size_t{0});  // not worth waking a thread
    return;
  }
#ifdef _OPENMP
#pragma omp parallel for schedule(static)
#endif
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    const std::size_t begin = static_cast<std::size_t>(c) * chunk_size;
    const std::size_t end = begin + chunk_size < count ? begin + chunk_size : count;
    body(begin, end, static_cast<std::size_t>(c));
  }
}

inline std::size_t chunk_count(std::size_t count, std::size_t chunk_size) {
  return (count + chunk_size - 1) / chunk_size;
}

}  // namespace pendular
