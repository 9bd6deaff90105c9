// SPDX-License-Identifier: BSD-3-Clause
// What the header of a law may take from elsewhere: nothing but the small headers of the standard library.
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
