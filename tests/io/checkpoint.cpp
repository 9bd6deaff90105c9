// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/checkpoint.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "scratch.hpp"

using pendular::io::checkpoint_element;
using pendular::io::checkpoint_reader;
using pendular::io::checkpoint_scalar;
using pendular::io::checkpoint_writer;

static_assert(checkpoint_scalar<bool> && !checkpoint_element<bool>);
static_assert(checkpoint_element<std::size_t> && checkpoint_element<long long>);
static_assert(!checkpoint_scalar<char> && !checkpoint_scalar<short> && !checkpoint_scalar<long double> &&
              !checkpoint_scalar<const char*> && !checkpoint_scalar<wchar_t>);

namespace {

void write_example(const std::filesystem::path& path) {
  checkpoint_writer out{path};
  out.put("time", 0.125);
  out.put("x", std::vector<double>{1, 2, 3});
  out.put("scene", "direct shear");
  out.commit();
}

std::string why_unreadable(const std::filesystem::path& path) {
  return scratch::message<std::runtime_error>([&] { checkpoint_reader{path}; });
}

/// CRC-32 of ISO 3309, bit by bit.
std::uint32_t crc_by_bits(const std::string& bytes) {
  std::uint32_t crc = ~0u;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

/// Gives altered content a right checksum again.
std::string sealed(std::string bytes) {
  bytes.resize(bytes.size() - 4);
  const std::uint32_t crc = crc_by_bits(bytes);
  return bytes.append(reinterpret_cast<const char*>(&crc), 4);
}

}  // namespace

TEST_CASE("every type comes back bit by bit", "[io][checkpoint]") {
  const scratch::folder folder;
  using limits = std::numeric_limits<double>;
  const double odd_nan = std::bit_cast<double>(std::uint64_t{0xFFF8'0000'DEAD'BEEF});
  const std::vector<double> doubles{limits::denorm_min(), -0.0, limits::infinity(), odd_nan, 0.1, limits::max()};
  const std::array<float, 2> floats{0.1f, std::numeric_limits<float>::denorm_min()};
  const std::vector<std::uint8_t> bytes{0, 255, 10};
  checkpoint_writer out{folder / "c"};
  out.put("doubles", std::span<const double>{doubles});
  out.put("floats", floats);
  out.put("bytes", bytes);
  out.put("int32", std::int32_t{-7});
  out.put("int64", std::numeric_limits<std::int64_t>::min());
  out.put("uint32", std::vector<std::uint32_t>{4'000'000'000u});
  out.put("uint64", std::numeric_limits<std::uint64_t>::max());
  out.put("yes", true);
  out.put("no", false);
  out.put("empty", std::vector<double>{});
  out.put("text", std::string{"a\0b \xC3\xA9", 6});
  out.put("", "no name is a name");
  out.commit();

  const checkpoint_reader in{folder / "c"};
  const auto read = in.get<std::vector<double>>("doubles");
  REQUIRE(read.size() == doubles.size());
  CHECK(std::memcmp(read.data(), doubles.data(), read.size() * sizeof(double)) == 0);
  CHECK(in.get<std::vector<float>>("floats") == std::vector<float>{floats[0], floats[1]});
  CHECK(in.get<std::vector<std::uint8_t>>("bytes") == bytes);
  CHECK(in.get<std::int32_t>("int32") == -7);
  CHECK(in.get<std::int64_t>("int64") == std::numeric_limits<std::int64_t>::min());
  CHECK(in.get<std::uint32_t>("uint32") == 4'000'000'000u);
  CHECK(in.get<std::vector<std::uint64_t>>("uint64") == std::vector{std::numeric_limits<std::uint64_t>::max()});
  CHECK(in.get<bool>("yes"));
  CHECK_FALSE(in.get<bool>("no"));
  CHECK(in.get<std::vector<double>>("empty").empty());
  CHECK(in.get<std::string>("text") == std::string{"a\0b \xC3\xA9", 6});
  CHECK(in.get<std::string>("") == "no name is a name");
  CHECK(in.has("empty"));
  CHECK_FALSE(in.has("empt"));
}

TEST_CASE("a request that does not fit the record says what it holds", "[io][checkpoint]") {
  const scratch::folder folder;
  write_example(folder / "c");
  const checkpoint_reader in{folder / "c"};
  const auto said = [](auto call) { return scratch::message<std::runtime_error>(call); };
  CHECK(scratch::mentions(said([&] { in.get<float>("time"); }), {"'time'", "as double, not as float"}));
  CHECK(scratch::mentions(said([&] { in.get<std::vector<std::int64_t>>("x"); }), {"'x'", "not as std::int64_t"}));
  CHECK(scratch::mentions(said([&] { in.get<double>("scene"); }), {"'scene'", "as std::string"}));
  CHECK(scratch::mentions(said([&] { in.get<double>("x"); }), {"3 values in 'x'", "std::vector"}));
  CHECK(scratch::mentions(said([&] { in.get<double>("y"); }), {(folder / "c").string(), "no record 'y'"}));
}

TEST_CASE("every damaged byte and every truncation is noticed", "[io][checkpoint]") {
  const scratch::folder folder;
  write_example(folder / "c");
  const std::string good = scratch::content(folder / "c");
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    scratch::write(folder / "d", damaged);
    CHECK(scratch::mentions(why_unreadable(folder / "d"), {"pendular: checkpoint", "d'"}));
    scratch::write(folder / "d", good.substr(0, i));
    CHECK(scratch::mentions(why_unreadable(folder / "d"), {"truncated"}));
  }
  scratch::write(folder / "d", good + "x");
  CHECK(scratch::mentions(why_unreadable(folder / "d"), {"corrupted", "bytes"}));
}

TEST_CASE("each kind of damage has its own sentence", "[io][checkpoint]") {
  const scratch::folder folder;
  write_example(folder / "c");
  const std::string good = scratch::content(folder / "c");
  const auto altered = [&](std::size_t place, char byte) {
    std::string bytes = good;
    bytes[place] = byte;
    scratch::write(folder / "d", sealed(bytes));
    return why_unreadable(folder / "d");
  };
  CHECK(sealed(good) == good);
  CHECK(scratch::mentions(altered(0, 'P'), {"not a pendular checkpoint"}));
  CHECK(scratch::mentions(altered(8, 9), {"version 9", "reads version 1"}));
  CHECK(scratch::mentions(altered(12, 1), {"byte order"}));
  std::string bytes = good;
  bytes[good.size() - 10] ^= 1;
  scratch::write(folder / "d", bytes);
  CHECK(scratch::mentions(why_unreadable(folder / "d"), {"CRC-32", "older checkpoint"}));
  CHECK(scratch::mentions(why_unreadable(folder / "absent"), {"absent", "cannot be opened"}));
  CHECK(scratch::mentions(why_unreadable(folder / "."), {"cannot be opened"}));
}

TEST_CASE("the old checkpoint stays until the new one is complete", "[io][checkpoint]") {
  const scratch::folder folder;
  write_example(folder / "c");
  const std::string old = scratch::content(folder / "c");
  {
    checkpoint_writer abandoned{folder / "c"};
    abandoned.put("time", 1.0);
    CHECK(scratch::mentions(scratch::message<std::invalid_argument>([&] { abandoned.put("time", 2.0); }), {"'time'"}));
  }
  CHECK(scratch::content(folder / "c") == old);

  std::filesystem::create_directories(folder / "c.tmp/inside");  // the temporary cannot be opened
  checkpoint_writer refused{folder / "c"};
  refused.put("time", 1.0);
  CHECK(scratch::mentions(scratch::message<std::runtime_error>([&] { refused.commit(); }), {"cannot write"}));
  CHECK(scratch::content(folder / "c") == old);
  std::filesystem::remove_all(folder / "c.tmp");
  refused.commit();
  CHECK(checkpoint_reader{folder / "c"}.get<double>("time") == 1.0);
}
