// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>

// Checkpoints byte by byte, as docs/reference/io.md describes them: taken apart and put together without the library.
namespace checkpoint_bytes {

inline constexpr std::size_t head = 32, tail = 4;  // bytes, by docs/reference/io.md

/// CRC-32 of ISO 3309, bit by bit.
inline std::uint32_t crc_by_bits(const std::string& bytes) {
  std::uint32_t crc = ~0u;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

template <class T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// `content` without its checksum, with the size and the checksum that belong to it.
inline std::string sealed(std::string content) {
  content.replace(16, 8, bytes_of(std::uint64_t{content.size() + tail}));
  return content + bytes_of(crc_by_bits(content));
}

/// A file as docs/reference/io.md describes it, read from its front, a field at a time.
class front {
 public:
  explicit front(std::string_view rest) : rest_{rest} {}
  std::optional<std::string> text(std::uint64_t size) {
    if (size > rest_.size()) return std::nullopt;
    std::string taken{rest_.substr(0, size)};
    rest_.remove_prefix(size);
    return taken;
  }
  template <class T>
  std::optional<T> number() {
    const auto bytes = text(sizeof(T));
    if (!bytes) return std::nullopt;
    T value;
    std::memcpy(&value, bytes->data(), sizeof value);
    return value;
  }
  bool empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

struct field {
  int type;
  std::string bytes;
  bool operator==(const field&) const = default;
};
using fields = std::map<std::string, field>;

/// The records between head and checksum, or nothing where they do not fit.
inline std::optional<fields> decoded(const std::string& content) {
  const std::map<int, std::uint64_t> sizes{{1, 8}, {2, 4}, {3, 4}, {4, 8}, {5, 4}, {6, 8}, {7, 1}, {8, 1}};
  std::uint64_t records;
  std::memcpy(&records, content.data() + 24, 8);
  front rest(std::string_view{content}.substr(head));
  fields all;
  for (std::uint64_t k = 0; k < records; ++k) {
    const auto length = rest.number<std::uint32_t>();
    const auto name = length ? rest.text(*length) : std::nullopt;
    const auto type = name ? rest.number<std::uint8_t>() : std::nullopt;
    const auto count = type ? rest.number<std::uint64_t>() : std::nullopt;
    if (!count || !sizes.contains(*type) || *count > content.size()) return std::nullopt;
    const auto bytes = rest.text(*count * sizes.at(*type));
    if (!bytes || !all.try_emplace(*name, field{*type, *bytes}).second) return std::nullopt;
  }
  if (!rest.empty()) return std::nullopt;
  return all;
}

/// The bytes of a file with these records, with the head of another.
inline std::string encoded(const fields& all, const std::string& like) {
  std::string content = like.substr(0, head);
  content.replace(24, 8, bytes_of(std::uint64_t{all.size()}));
  const std::map<int, std::uint64_t> sizes{{1, 8}, {2, 4}, {3, 4}, {4, 8}, {5, 4}, {6, 8}, {7, 1}, {8, 1}};
  for (const auto& [name, f] : all) {
    content += bytes_of(static_cast<std::uint32_t>(name.size())) + name + bytes_of(static_cast<std::uint8_t>(f.type)) +
               bytes_of(std::uint64_t{f.bytes.size() / sizes.at(f.type)}) + f.bytes;
  }
  return sealed(content);
}

}  // namespace checkpoint_bytes
