// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <boost/crc.hpp>

/// File layout, all numbers in the byte order of the writer: "pendular", version (uint32), byte-order mark (uint32),
/// size of the file (uint64), number of records (uint64); per record the length of its name (uint32), the name, the
/// element type (uint8), the number of elements (uint64), the elements; last the CRC-32 (uint32) of all before it.
namespace pendular::io {

/// What an array of a checkpoint may hold.
template <class T>
concept checkpoint_element = std::same_as<T, double> || std::same_as<T, float> || std::same_as<T, std::uint8_t> ||
    (std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, wchar_t> && !std::same_as<T, char32_t> &&
     (sizeof(T) == 4 || sizeof(T) == 8));

/// What a single value of a checkpoint may be; bool is stored as uint8.
template <class T>
concept checkpoint_scalar = checkpoint_element<T> || std::same_as<T, bool>;

namespace detail {

enum class element : std::uint8_t { float64 = 1, float32, int32, int64, uint32, uint64, uint8, text };

inline constexpr std::array element_names{
    "?",          "double", "float", "std::int32_t", "std::int64_t", "std::uint32_t", "std::uint64_t", "std::uint8_t",
    "std::string"};

template <checkpoint_scalar T>
consteval element element_of() {
  if constexpr (sizeof(T) == 1) return element::uint8;
  else if constexpr (std::same_as<T, double>) return element::float64;
  else if constexpr (std::same_as<T, float>) return element::float32;
  else if constexpr (std::signed_integral<T>) return sizeof(T) == 4 ? element::int32 : element::int64;
  else return sizeof(T) == 4 ? element::uint32 : element::uint64;
}

inline std::size_t element_size(element e) {
  if (e == element::uint8 || e == element::text) return 1;
  return e == element::float32 || e == element::int32 || e == element::uint32 ? 4 : 8;
}

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline std::uint32_t crc32(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

inline constexpr std::string_view checkpoint_magic = "pendular";
inline constexpr std::uint32_t checkpoint_version = 1;
inline constexpr std::uint32_t byte_order_mark = 0x01020304;
inline constexpr std::size_t checkpoint_header = 32;  // bytes
inline constexpr std::size_t checkpoint_trailer = 4;  // bytes

}  // namespace detail

}  // namespace pendular::io
