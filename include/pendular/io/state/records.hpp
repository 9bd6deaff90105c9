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

/// A sum, as the numbers that it is made of and, before them, how many these are.
inline void put_sum(checkpoint_writer& out, const std::string& name, const reproducible_sum& sum) {
  std::vector<double> record = sum.parts();
  record.insert(record.begin(), static_cast<double>(record.size()));
  out.put(name, record);
}
inline reproducible_sum get_sum(const checkpoint_reader& in, const std::string& name) {
  const auto record = in.get<std::vector<double>>(name);
  if (record.empty() || record[0] != static_cast<double>(record.size() - 1)) {
    refuse_content("the sum " + name + " is not all there");
  }
  reproducible_sum sum;
  for (std::size_t k = 1; k < record.size(); ++k) {
    if (!std::isfinite(record[k])) refuse_content("the sum " + name + " is not finite");
    sum.add(record[k]);
  }
  return sum;
}

}  // namespace pendular::io::detail
