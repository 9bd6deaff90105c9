// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/reproducible_sum.hpp>
#include <pendular/io/checkpoint.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular::io::detail {

[[noreturn]] inline void refuse_content(const std::string& what) {
  throw std::runtime_error("the checkpoint does not fit together: " + what +
                           ": it is damaged or of another scene (see docs/how-to/resume.md)");
}

/// Something that is counted, and will be counted on.
inline void expect_count(const std::string& of_what, std::int64_t count) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  if (count < 0 || count > most) refuse_content("it counts " + std::to_string(count) + " " + of_what);
}

/// Keys of so many numbers each. Errors: a part of a key is missing.
template <class T>
std::vector<T> get_keys(const checkpoint_reader& in, const std::string& name, std::size_t numbers_per_key) {
  std::vector<T> keys = in.get<std::vector<T>>(name);
  if (keys.size() % numbers_per_key != 0) {
    refuse_content("the record " + name + " has " + std::to_string(keys.size()) + " numbers, which are no whole keys");
  }
  return keys;
}

/// A sum that is kept as the numbers it is made of. Errors: one of them is not finite.
inline reproducible_sum sum_of(const std::vector<double>& parts) {
  reproducible_sum sum;
  for (const double v : parts) {
    if (!std::isfinite(v)) refuse_content("one of its sums is not finite");
    sum.add(v);
  }
  return sum;
}
inline reproducible_sum get_sum(const checkpoint_reader& in, const std::string& name) {
  return sum_of(in.get<std::vector<double>>(name));
}

}  // namespace pendular::io::detail
