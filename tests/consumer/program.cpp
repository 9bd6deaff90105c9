// SPDX-License-Identifier: BSD-3-Clause
// A program of every small project here: one header of each library that pendular brings, and the version twice.
#include <pendular/io/checkpoint_format.hpp>
#include <pendular/law/stiffness.hpp>
#include <pendular/version.hpp>
#include <range/v3/version.hpp>

static_assert(PENDULAR_VERSION_MAJOR == VERSION_OF_CMAKE_MAJOR && PENDULAR_VERSION_MINOR == VERSION_OF_CMAKE_MINOR &&
              PENDULAR_VERSION_PATCH == VERSION_OF_CMAKE_PATCH);
static_assert(PENDULAR_VERSION ==
              10000 * VERSION_OF_CMAKE_MAJOR + 100 * VERSION_OF_CMAKE_MINOR + VERSION_OF_CMAKE_PATCH);

int main() {
  // The check value of CRC-32 in the catalogue of Cook.
  return pendular::io::detail::crc32("123456789") == 0xCBF43926u ? 0 : 1;
}
