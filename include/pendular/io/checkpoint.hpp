// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <ranges>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <pendular/io/atomic_file.hpp>
#include <pendular/io/checkpoint_format.hpp>
#include <pendular/io/number.hpp>

namespace pendular::io {

/// Collects named records in memory; commit() writes them. Until commit() has returned, and if it throws, the
/// checkpoint that stood at the path before is untouched.
class checkpoint_writer {
 public:
  explicit checkpoint_writer(std::filesystem::path path) : path_{std::move(path)} {}

  template <checkpoint_scalar T>
  void put(std::string_view name, T value) {
    record(name, detail::element_of<T>(), 1, &value, sizeof(T));
  }

  /// Any contiguous range of numbers: std::vector, std::span, std::array.
  template <std::ranges::contiguous_range R>
    requires checkpoint_element<std::ranges::range_value_t<R>>
  void put(std::string_view name, const R& values) {
    using value_type = std::ranges::range_value_t<R>;
    const std::size_t count = std::ranges::size(values);
    record(name, detail::element_of<value_type>(), count, std::ranges::data(values), count * sizeof(value_type));
  }

  void put(std::string_view name, std::string_view text) {
    record(name, detail::element::text, text.size(), text.data(), text.size());
  }

  /// Throws std::runtime_error when the file cannot be written.
  void commit() const {
    std::string bytes{detail::checkpoint_magic};
    detail::append(bytes, detail::checkpoint_version);
    detail::append(bytes, detail::byte_order_mark);
    detail::append(bytes, std::uint64_t{detail::checkpoint_header + records_.size() + detail::checkpoint_trailer});
    detail::append(bytes, std::uint64_t{names_.size()});
    bytes += records_;
    detail::append(bytes, detail::crc32(bytes));
    atomic_file file{path_};
    file.write(bytes);
    file.commit();
  }

 private:
  std::filesystem::path path_;
  std::set<std::string> names_;
  std::string records_;

  void record(std::string_view name, detail::element type, std::size_t count, const void* bytes, std::size_t size) {
    if (!names_.emplace(name).second)
      throw std::invalid_argument("pendular: record '" + std::string{name} + "' is put twice into checkpoint '" +
                                  path_.string() + "'; give each record its own name");
    detail::append(records_, static_cast<std::uint32_t>(name.size()));
    records_ += name;
    detail::append(records_, type);
    detail::append(records_, std::uint64_t{count});
    if (size != 0) records_.append(static_cast<const char*>(bytes), size);
  }
};

/// Reads and verifies a whole checkpoint. Every error is a std::runtime_error of one sentence that names the file, says
/// what is wrong, what to do and where to read.
class checkpoint_reader {
 public:
  explicit checkpoint_reader(std::filesystem::path path) : path_{std::move(path)} {
    load();
    verify();
    index();
  }

  bool has(std::string_view name) const { return records_.contains(name); }

  /// Number of elements of the record, of whatever type.
  std::size_t count(std::string_view name) const { return find(name).count; }

  /// `T` is std::vector of a number, a number, bool or std::string, and must be the type that was put.
  template <class T>
  T get(std::string_view name) const {
    if constexpr (std::same_as<T, std::string>) {
      const entry& e = find(name, detail::element::text);
      return bytes_.substr(e.offset, e.count);
    } else if constexpr (std::same_as<T, bool>) {
      const auto value = get<std::uint8_t>(name);
      require(value <= 1, name, value, "0 or 1, as a bool");
      return value == 1;
    } else if constexpr (checkpoint_scalar<T>) {
      const entry& e = find(name, detail::element_of<T>());
      if (e.count != 1)
        refuse("holds " + std::to_string(e.count) + " values in " + quoted(name) + "; read it as a std::vector");
      return number<T>(e.offset);
    } else {
      static_assert(checkpoint_element<typename T::value_type>, "a checkpoint holds numbers of 4 or 8 bytes and uint8");
      const entry& e = find(name, detail::element_of<typename T::value_type>());
      T values(e.count);
      if (e.count != 0) std::memcpy(values.data(), bytes_.data() + e.offset, e.count * sizeof(typename T::value_type));
      return values;
    }
  }

  /// The same of a std::vector that must have so many elements.
  template <class T>
  T get(std::string_view name, std::size_t elements) const {
    const std::size_t there = count(name);
    if (there != elements)
      refuse("holds " + std::to_string(there) + " values in " + quoted(name) + ", where " + std::to_string(elements) +
             " are needed; it may come from another scene or release");
    return get<T>(name);
  }

  /// Throws the error that this file `what`.
  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error("pendular: checkpoint '" + path_.string() + "' " + what + " (see docs/reference/io.md)");
  }

  /// Refuses a record by one of its values: `bound` says what this must be.
  void require(bool holds, std::string_view name, double value, std::string_view bound) const {
    if (!holds)
      refuse("holds " + shortest(value) + " in " + quoted(name) + ", where a value must be " + std::string{bound} +
             "; restart from another checkpoint");
  }

 private:
  struct entry {
    detail::element type;
    std::size_t count;
    std::size_t offset;  // of the first element in the file, bytes
  };

  static constexpr auto again = "; restart from an older checkpoint";

  std::filesystem::path path_;
  std::string bytes_;
  std::map<std::string, entry, std::less<>> records_;

  /// A name as it may stand in a sentence, whatever its bytes are.
  static std::string quoted(std::string_view name) {
    constexpr std::size_t most = 60;
    std::string text = "'";
    for (const char c : name.substr(0, most)) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    return text + (name.size() > most ? "...'" : "'");
  }

  template <class T>
  T number(std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }

  void load() {
    std::error_code error;
    const auto size = std::filesystem::file_size(path_, error);  // an error for a folder, too
    std::ifstream file{path_, std::ios::binary};
    if (error || !file) refuse("cannot be opened; check the path and its permissions");
    bytes_.resize(static_cast<std::size_t>(size));
    file.read(bytes_.data(), static_cast<std::streamsize>(size));
    if (!file) refuse("cannot be read to its end; check the disc");
  }

  void verify() const {
    const auto magic = std::string_view{bytes_}.substr(0, detail::checkpoint_magic.size());
    if (!detail::checkpoint_magic.starts_with(magic)) refuse("is not a pendular checkpoint; check the path");
    if (bytes_.size() < detail::checkpoint_header + detail::checkpoint_trailer)
      refuse("is truncated to " + std::to_string(bytes_.size()) + " bytes" + again);
    if (number<std::uint32_t>(12) != detail::byte_order_mark)
      refuse("was written with another byte order or is corrupted; read it on the kind of machine that wrote it");
    if (const auto version = number<std::uint32_t>(8); version != detail::checkpoint_version)
      refuse("has format version " + std::to_string(version) + " and this library reads version " +
             std::to_string(detail::checkpoint_version) + "; use the release that wrote it");
    if (const auto size = number<std::uint64_t>(16); size != bytes_.size())
      refuse((size > bytes_.size() ? "is truncated: it has " : "is corrupted: it has ") +
             std::to_string(bytes_.size()) + " bytes and should have " + std::to_string(size) + again);
    const std::size_t end = bytes_.size() - detail::checkpoint_trailer;
    if (detail::crc32(std::string_view{bytes_}.substr(0, end)) != number<std::uint32_t>(end))
      refuse("is corrupted: its CRC-32 does not match its content" + std::string{again});
  }

  /// The checksum is right also for what a faulty or foreign program wrote: every length is held against the file.
  void index() {
    const std::size_t end = bytes_.size() - detail::checkpoint_trailer;
    const auto wanted = number<std::uint64_t>(24);
    std::size_t at = detail::checkpoint_header;
    for (std::uint64_t k = 1; k <= wanted; ++k) {
      const std::string which = "record " + std::to_string(k) + " of " + std::to_string(wanted);
      expect_room(4, 1, end - at, "the head of " + which);
      const auto length = number<std::uint32_t>(at);
      expect_room(length, 1, end - at - 4, "the name of " + which);
      std::string name = bytes_.substr(at + 4, length);
      at += 4 + length;
      expect_room(9, 1, end - at, "the head of record " + quoted(name));
      const entry e{number<detail::element>(at), number<std::uint64_t>(at + 1), at + 9};
      expect_known(e.type, name);
      expect_room(e.count, detail::element_size(e.type), end - e.offset, "record " + quoted(name));
      at = e.offset + e.count * detail::element_size(e.type);
      if (!records_.emplace(name, e).second) refuse("is malformed: it has two records " + quoted(name) + again);
    }
    if (at != end)
      refuse("is malformed: it has " + std::to_string(end - at) + " bytes beyond its " + std::to_string(wanted) +
             " records" + again);
  }

  void expect_room(std::uint64_t elements, std::size_t size, std::size_t room, const std::string& what) const {
    if (elements > room / size)
      refuse("is malformed: " + what + " has " + std::to_string(elements) + " elements of " + std::to_string(size) +
             (size == 1 ? " byte, where " : " bytes, where ") + std::to_string(room) + " bytes are left" + again);
  }

  void expect_known(detail::element type, std::string_view name) const {
    const auto code = static_cast<std::size_t>(type);
    if (code == 0 || code >= detail::element_names.size())
      refuse("is malformed: record " + quoted(name) + " has element type " + std::to_string(code) + ", where 1 to " +
             std::to_string(detail::element_names.size() - 1) + " are known" + again);
  }

  const entry& find(std::string_view name) const {
    const auto found = records_.find(name);
    if (found == records_.end())
      refuse("has no record " + quoted(name) + "; it may come from another scene or release");
    return found->second;
  }

  const entry& find(std::string_view name, detail::element type) const {
    const entry& e = find(name);
    if (e.type != type)
      refuse("holds " + quoted(name) + " as " + detail::element_names[static_cast<std::size_t>(e.type)] + ", not as " +
             detail::element_names[static_cast<std::size_t>(type)] + "; read it as the type that was put");
    return e;
  }
};

}  // namespace pendular::io
