// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a tag of grains needs the type of its value: `using type = double`
// expect 2: a tag of grains needs `static constexpr std::string_view label` and `unit`
// expect 3: a tag of grains needs `static constexpr std::string_view label` and `unit`
// expect 4: the value of a tag of grains is a double, a std::int64_t or a vector
#include <pendular/space/check.hpp>

#include <string_view>

using namespace pendular;

struct temperature {
#if PENDULAR_MISTAKE == 4
  using type = float;
#elif PENDULAR_MISTAKE != 1
  using type = double;
#endif
#if PENDULAR_MISTAKE == 2
  static constexpr std::string_view unit = "K";
#elif PENDULAR_MISTAKE == 3
  static constexpr std::string_view label = "temperature";
#else
  static constexpr std::string_view label = "temperature", unit = "K";
#endif
};

static_assert(check::grain_tag<temperature>);
