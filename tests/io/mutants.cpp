// SPDX-License-Identifier: BSD-3-Clause
// Files whose checksum is right and whose content is not: each is read as what it says, or refused in one sentence.
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/table.hpp>
#include <pendular/scene/box_packing.hpp>
#include <pendular/scene/compression_result.hpp>
#include <pendular/scene/packing.hpp>
#include <pendular/scene/result_file.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "checkpoint_bytes.hpp"
#include "scratch.hpp"

namespace io = pendular::io;
namespace scene = pendular::scene;
using pendular::grain;
using namespace checkpoint_bytes;

namespace {

template <class T>
field read_as(const io::checkpoint_reader& in, const std::string& name, int type) {
  std::string bytes;
  for (const T& value : in.get<std::vector<T>>(name)) bytes += bytes_of(value);
  return {type, bytes};
}

/// A record as the reader gives it, asked for by the type that the decoder saw.
field read(const io::checkpoint_reader& in, const std::string& name, int type) {
  if (type == 1) return read_as<double>(in, name, type);
  if (type == 2) return read_as<float>(in, name, type);
  if (type == 3) return read_as<std::int32_t>(in, name, type);
  if (type == 4) return read_as<std::int64_t>(in, name, type);
  if (type == 5) return read_as<std::uint32_t>(in, name, type);
  if (type == 6) return read_as<std::uint64_t>(in, name, type);
  if (type == 7) return read_as<std::uint8_t>(in, name, type);
  return {type, in.get<std::string>(name)};
}

bool is_one_sentence(const std::string& text) {
  UNSCOPED_INFO(text);
  return text.find('\n') == std::string::npos && text.find("(see docs/") != std::string::npos && text.size() < 600;
}

struct tally {
  int read = 0, refused = 0;
};

/// The reader must take what the decoder takes, as the same values, and refuse all else.
void expect_right(const std::filesystem::path& path, const std::string& content, tally& seen) {
  scratch::write(path, sealed(content));
  const auto expected = decoded(content);
  std::optional<io::checkpoint_reader> in;
  const auto said = scratch::message<std::runtime_error>([&] { in.emplace(path); });
  if (!expected) {
    REQUIRE(is_one_sentence(said));
    REQUIRE(scratch::mentions(said, {"pendular: checkpoint '" + path.string() + "'"}));
    ++seen.refused;
    return;
  }
  REQUIRE(said == "no error");
  for (const auto& [name, expected_field] : *expected) {
    REQUIRE(in->has(name));
    REQUIRE(read(*in, name, expected_field.type) == expected_field);
  }
  ++seen.read;
}

/// A file with every type of element, an empty record and one without a name, as bytes before the checksum.
std::string small_checkpoint(const std::filesystem::path& path) {
  io::checkpoint_writer out{path};
  out.put("system.grains", std::uint64_t{2});
  out.put("grain.radius", std::vector<double>{1e-3, 2e-3});
  out.put("floats", std::vector<float>{1, 2, 3});
  out.put("int32", std::int32_t{-7});
  out.put("keys", std::vector<std::int64_t>{0, 1, -1});
  out.put("uint32", std::uint32_t{7});
  out.put("bytes", std::vector<std::uint8_t>{1, 2, 3});
  out.put("empty", std::vector<double>{});
  out.put("yes", true);
  out.put("", "no name is a name");
  out.commit();
  const std::string bytes = scratch::content(path);
  return bytes.substr(0, bytes.size() - tail);
}

/// Where the numbers stand that say how long something is: their offset and size in bytes.
std::vector<std::pair<std::size_t, std::size_t>> lengths_in(const std::string& content) {
  std::vector<std::pair<std::size_t, std::size_t>> places{{24, 8}};
  const auto all = decoded(content);
  for (std::size_t at = head; at < content.size();) {
    std::uint32_t length;
    std::memcpy(&length, content.data() + at, 4);
    places.insert(places.end(), {{at, 4}, {at + 4 + length + 1, 8}});
    at += 4 + length + 9 + all->at(content.substr(at + 4, length)).bytes.size();
  }
  return places;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
const std::vector<double> wrong_numbers{no_number, -inf, inf, -1, -0.0, 0, 5e-324, 1e-300, 1e300, 1.7e308, 1e-3, 1};

/// Three grains in a cylinder of 10 mm, by hand: volume 4/3 pi (1 + 8 + 27) mm3 = 150.796 447 37 mm3.
scene::sealed_packing three_grains() {
  const double volume = 150.79644737231007e-9, room = std::numbers::pi * 1e-4 * 0.02;
  return {{{{0, 0, 1e-3}, 1e-3, 2000}, {{5e-3, 0, 2e-3}, 2e-3, 2000}, {{0, -6e-3, 3e-3}, 3e-3, 2000}},
          0.02,
          volume / room,
          2000 * volume,
          0.01};
}

bool has_sense(const std::vector<grain>& grains) {
  bool all = !grains.empty();
  for (const grain& g : grains) {
    for (const double x : {g.position.x, g.position.y, g.position.z}) all = all && std::abs(x) < 1;
    all = all && g.radius > 0 && g.radius < 1 && g.density > 0 && g.density < inf;
  }
  return all;
}

using numbers = std::vector<double>;

/// Calls `load` on files with one number changed, or one number more or less.
void with_each_mutant(const std::string& record, const numbers& right,
                      const std::function<void(const io::checkpoint_reader&)>& load) {
  const scratch::folder folder;
  const auto try_one = [&](const numbers& n) {
    io::checkpoint_writer out(folder / "mutant");
    out.put(record, n);
    out.commit();
    load(io::checkpoint_reader(folder / "mutant"));
  };
  for (std::size_t size = 0; size < right.size() + 7; ++size) {
    numbers n = right;
    n.resize(size, 1e-3);
    try_one(n);
  }
  std::mt19937_64 random(5);
  for (std::size_t k = 0; k < right.size(); ++k) {
    numbers n = right;
    for (const double wrong : wrong_numbers) n[k] = wrong, try_one(n);
    for (int bit = 0; bit < 64; ++bit) {
      n[k] = right[k];
      std::uint64_t bits;
      std::memcpy(&bits, &n[k], 8);
      bits ^= std::uint64_t{1} << bit;
      std::memcpy(&n[k], &bits, 8);
      try_one(n);
    }
  }
}

}  // namespace

TEST_CASE("each byte of a checkpoint changed under a right checksum is read as it stands or refused", "[io][mutants]") {
  const scratch::folder folder;
  const std::string good = small_checkpoint(folder / "c");
  tally seen;
  expect_right(folder / "d", good, seen);
  REQUIRE(seen.read == 1);
  for (std::size_t at = 24; at < good.size(); ++at) {
    for (const int mask : {0x01, 0x02, 0x04, 0x08, 0x80, 0xFF}) {
      std::string bytes = good;
      bytes[at] = static_cast<char>(bytes[at] ^ mask);
      expect_right(folder / "d", bytes, seen);
    }
  }
  CHECK(seen.read > 100);
  CHECK(seen.refused > 300);
}

TEST_CASE("lengths of any size are held against the file", "[io][mutants]") {
  const scratch::folder folder;
  const std::string good = small_checkpoint(folder / "c");
  tally seen;
  for (const auto& [at, size] : lengths_in(good)) {
    for (int bit = 0; bit < 64; ++bit) {
      for (const std::uint64_t less : {0, 1, 9}) {
        const std::uint64_t length = (std::uint64_t{1} << bit) - less;
        std::string bytes = good;
        bytes.replace(at, size, bytes_of(length).substr(0, size));
        expect_right(folder / "d", bytes, seen);
      }
    }
  }
  CHECK(seen.refused > 2000);
}

TEST_CASE("checkpoints that are cut, spliced or stirred under a right checksum are refused or read", "[io][mutants]") {
  const scratch::folder folder;
  const std::string good = small_checkpoint(folder / "c");
  tally seen;
  for (std::size_t size = head; size < good.size(); ++size) expect_right(folder / "d", good.substr(0, size), seen);
  expect_right(folder / "d", good + std::string(13, '\0'), seen);
  std::mt19937_64 random(7);
  const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
  for (int k = 0; k < 3000; ++k) {
    std::string bytes = good;
    const std::size_t from = head + below(good.size() - head), to = head + below(good.size() - head);
    const std::size_t size = 1 + below(12);
    if (k % 3 == 0) bytes.erase(from, size);
    else if (k % 3 == 1) bytes.insert(from, good.substr(to, size));
    else
      for (std::size_t n = 0; n < size; ++n) bytes[head + below(good.size() - head)] = static_cast<char>(random());
    expect_right(folder / "d", bytes, seen);
  }
  CHECK(seen.refused > 2000);
}

TEST_CASE("a malformed record is named with what it says and what is left", "[io][mutants]") {
  const scratch::folder folder;
  const std::string good = small_checkpoint(folder / "c");
  const auto said = [&](const std::string& record, std::size_t offset, const std::string& bytes) {
    std::string content = good;
    content.replace(content.find(record) + record.size() + offset, bytes.size(), bytes);
    scratch::write(folder / "d", sealed(content));
    return scratch::message<std::runtime_error>([&] { io::checkpoint_reader in(folder / "d"); });
  };
  CHECK(scratch::mentions(said("grain.radius", 1, bytes_of(std::uint64_t{1} << 61)),
                          {"record 'grain.radius'", "2305843009213693952 elements of 8 bytes", "bytes are left",
                           "older checkpoint", "docs/reference/io.md"}));
  CHECK(scratch::mentions(said("grain.radius", 0, bytes_of(std::uint8_t{9})),
                          {"record 'grain.radius'", "element type 9", "1 to 8"}));
  const std::string breaking = said("grain.", 0, "\nadius" + bytes_of(std::uint8_t{9}));
  CHECK(scratch::mentions(breaking, {"record 'grain.?adius'"}));
  CHECK(is_one_sentence(breaking));
  std::string content = good;
  content.replace(content.find("bytes"), 5, "empty");
  scratch::write(folder / "d", sealed(content));
  CHECK(scratch::mentions(scratch::message<std::runtime_error>([&] { io::checkpoint_reader in(folder / "d"); }),
                          {"two records 'empty'"}));
}

TEST_CASE("a vector is asked for by its number of elements, a bool is 0 or 1", "[io][mutants]") {
  const scratch::folder folder;
  const std::string good = small_checkpoint(folder / "c");
  const io::checkpoint_reader in(folder / "c");
  CHECK(in.get<std::vector<double>>("grain.radius", 2) == std::vector<double>{1e-3, 2e-3});
  CHECK(in.count("keys") == 3);
  CHECK(in.count("empty") == 0);
  const auto said = [](auto call) { return scratch::message<std::runtime_error>(call); };
  CHECK(scratch::mentions(said([&] { in.get<std::vector<double>>("grain.radius", 3); }),
                          {(folder / "c").string(), "holds 2 values in 'grain.radius', where 3 are needed"}));
  CHECK(scratch::mentions(said([&] { in.get<std::vector<double>>("keys", 3); }), {"'keys' as std::int64_t"}));
  CHECK(scratch::mentions(said([&] { in.get<std::vector<double>>("absent", 3); }), {"no record 'absent'"}));
  CHECK(scratch::mentions(said([&] { static_cast<void>(in.count("absent")); }), {"no record 'absent'"}));
  in.require(true, "keys", 1, "at least 0");
  CHECK(scratch::mentions(said([&] { in.require(false, "keys", -1, "at least 0"); }),
                          {(folder / "c").string(), "holds -1 in 'keys'", "must be at least 0"}));
  std::string content = good;
  content[content.find("yes") + 3 + 9] = 2;
  scratch::write(folder / "d", sealed(content));
  CHECK(scratch::mentions(said([&] { io::checkpoint_reader(folder / "d").get<bool>("yes"); }),
                          {"holds 2 in 'yes'", "0 or 1"}));
}

TEST_CASE("a packing with a wrong number is refused or has sense", "[io][mutants]") {
  const auto right = three_grains();
  const scratch::folder folder;
  scene::write(right, folder / "right");
  const io::checkpoint_reader in(folder / "right");
  REQUIRE(scene::load_packing(in).grains.size() == 3);
  tally seen;
  with_each_mutant("packing.numbers", in.get<numbers>("packing.numbers"), [&](const io::checkpoint_reader& mutant) {
    try {
      const auto p = scene::load_packing(mutant);
      double mass = 0;
      for (const grain& g : p.grains) mass += g.density * 4 / 3 * std::numbers::pi * std::pow(g.radius, 3);
      REQUIRE(has_sense(p.grains));
      REQUIRE(std::abs(p.solid_mass / mass - 1) < 1e-8);
      REQUIRE((p.solid_fraction > 0 && p.solid_fraction < 1 && p.height > 0 && p.height < 1));
      ++seen.read;
    } catch (const pendular::input_error& error) {
      REQUIRE(is_one_sentence(error.what()));
      ++seen.refused;
    } catch (const std::runtime_error& error) {
      REQUIRE(is_one_sentence(error.what()));
      ++seen.refused;
    }
  });
  CHECK(seen.read > 100);
  CHECK(seen.refused > 500);
}

TEST_CASE("a packing in a box with a wrong number is refused or has sense", "[io][mutants]") {
  scene::boxed_packing right{three_grains().grains, {{-0.01, -0.01, 0}, {0.01, 0.01, 0.02}}, 300, 1e-4};
  scene::box_packing_parameters wanted;
  wanted.grains = 3, wanted.sizes = {{2e-3, 1.0 / 3}, {4e-3, 1.0 / 3}, {6e-3, 1.0 / 3}};
  const scratch::folder folder;
  scene::write(right, folder / "right");
  const io::checkpoint_reader in(folder / "right");
  REQUIRE(scene::load_boxed_packing(in, wanted).grains.size() == 3);
  tally seen;
  const auto load = [&](const io::checkpoint_reader& mutant) {
    try {
      const auto p = scene::load_boxed_packing(mutant, wanted);
      REQUIRE(has_sense(p.grains));
      REQUIRE(p.grains.size() == 3);
      REQUIRE(std::isfinite(p.stress));
      REQUIRE(p.unbalanced_force >= 0);
      ++seen.read;
    } catch (const pendular::input_error& error) {
      REQUIRE(is_one_sentence(error.what()));
      ++seen.refused;
    } catch (const std::runtime_error& error) {
      REQUIRE(is_one_sentence(error.what()));
      ++seen.refused;
    }
  };
  with_each_mutant("boxed_packing.numbers", in.get<numbers>("boxed_packing.numbers"), load);
  CHECK(seen.read > 100);
  CHECK(seen.refused > 250);
}

TEST_CASE("a packing says which number is wrong, by which bound, and where to read", "[io][mutants]") {
  const auto said = [](const std::function<void(scene::sealed_packing&)>& change) {
    auto p = three_grains();
    change(p);
    return scratch::message<pendular::input_error>([&] { scene::validate(p); });
  };
  CHECK(said([](auto&) {}) == "no error");
  const std::string page = "docs/reference/scenes.md";
  CHECK(scratch::mentions(said([](auto& p) { p.grains.clear(); }), {"number of grains", "0", "at least 1", page}));
  CHECK(
      scratch::mentions(said([](auto& p) { p.grains[1].radius = -1; }), {"radius of a grain", "-1", "positive", page}));
  CHECK(scratch::mentions(said([](auto& p) { p.grains[1].density = no_number; }), {"density of a grain", "nan", page}));
  CHECK(
      scratch::mentions(said([](auto& p) { p.grains[1].position.x = 0.5; }), {"from the axis", "0.5", "radius", page}));
  CHECK(scratch::mentions(said([](auto& p) { p.grains[1].position.z = 0.5; }), {"height of a grain", "0.5", page}));
  CHECK(scratch::mentions(said([](auto& p) { p.solid_mass *= 2; }), {"solid mass", "that of its grains", page}));
  CHECK(scratch::mentions(said([](auto& p) { p.solid_fraction = inf; }), {"solid fraction", "inf", page}));
  CHECK(scratch::mentions(said([](auto& p) { p.height = 0; }), {"height of the packing", "0", page}));
}

TEST_CASE("a result whose lists have other lengths than its numbers is refused before there is room for it",
          "[io][mutants]") {
  scene::compression_result right;
  right.reference.resize(3), right.relaxation.resize(2), right.records.resize(4);
  const scratch::folder folder;
  io::checkpoint_writer out(folder / "right");
  scene::save(out, right);
  out.commit();
  const io::checkpoint_reader in(folder / "right");
  scene::compression_result again;
  scene::load(in, again);
  CHECK(again.records.size() == 4);
  const auto all = in.get<numbers>("scene.numbers");
  const auto lengths = in.get<std::vector<std::int64_t>>("scene.lengths");
  const auto said = [&](const std::vector<std::int64_t>& l, const numbers& n) {
    io::checkpoint_writer wrong(folder / "wrong");
    wrong.put("scene.lengths", l), wrong.put("scene.numbers", n);
    wrong.commit();
    return scratch::message<std::runtime_error>([&] { scene::load(io::checkpoint_reader(folder / "wrong"), again); });
  };
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    for (const std::int64_t wrong :
         {std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, std::int64_t{1} << 32,
          std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
      auto l = lengths;
      l[k] = wrong;
      const std::string sentence = said(l, all);
      CHECK(is_one_sentence(sentence));
      CHECK(scratch::mentions(sentence, {"'scene.lengths'", "scene.numbers"}));
    }
  }
  CHECK(scratch::mentions(said({}, all), {"holds 0 values in 'scene.lengths', where 3 are needed"}));
  CHECK(scratch::mentions(said(lengths, {}), {"scene.lengths"}));
  CHECK(scratch::mentions(said({0, 0, 0}, {}), {"holds 0 values in 'scene.numbers'"}));
  CHECK(again.records.size() == 4);
}

TEST_CASE("a stage that a scene has not, or steps beyond it, are refused", "[io][mutants]") {
  const scratch::folder folder;
  io::checkpoint_writer out(folder / "c");
  out.put("scene.stage", "seal"), out.put("scene.done", std::int64_t{100});
  out.commit();
  const io::checkpoint_reader in(folder / "c");
  const scene::stages packing(1e-3, {{"deposit", 0.2}, {"seal", 0.1}});
  const scene::stages there = packing.read(in);
  CHECK((there.at("seal") && there.done() == 100 && there.steps() == 100 && packing.at("deposit")));
  const auto refusal = [&](const scene::stages& s) {
    return scratch::message<std::runtime_error>([&] { s.read(io::checkpoint_reader(folder / "c")); });
  };
  CHECK(scratch::mentions(refusal({1e-3, {{"relax", 0.2}, {"compress", 0.1}}}),
                          {"'scene.stage'", "'relax', 'compress'"}));
  CHECK(scratch::mentions(refusal({1e-3, {{"deposit", 0.2}, {"seal", 0.099}}}),
                          {"holds 100 in 'scene.done'", "0 to the stage's 99 steps"}));
  io::checkpoint_writer negative(folder / "c");
  negative.put("scene.stage", "seal"), negative.put("scene.done", std::int64_t{-1});
  negative.commit();
  CHECK(scratch::mentions(refusal(packing), {"holds -1 in 'scene.done'"}));
}

TEST_CASE("a grading with a class that is none is refused", "[io][mutants]") {
  const auto said = [](const scene::grading& g, std::int64_t grains) {
    return scratch::message<pendular::input_error>([&] { scene::diameters(g, grains, 1); });
  };
  CHECK(said({{1e-3, 0.5}, {2e-3, 0.5}}, 4) == "no error");
  CHECK(scratch::mentions(said({}, 4), {"number of classes", "0"}));
  CHECK(scratch::mentions(said({{-1e-3, 1}}, 4), {"diameter of a grading", "-0.001", "positive"}));
  CHECK(scratch::mentions(said({{no_number, 1}}, 4), {"diameter of a grading", "nan"}));
  CHECK(scratch::mentions(said({{1e-3, 1.5}, {2e-3, -0.5}}, 4), {"proportion of a grading", "-0.5"}));
  CHECK(scratch::mentions(said({{1e-3, no_number}}, 4), {"proportion of a grading", "nan"}));
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1} << 31, std::int64_t{1} << 62})
    CHECK(scratch::mentions(said({{1e-3, 1}}, count), {"number of grains", "2^31"}));
}

TEST_CASE("a table whose bytes are stirred is read or refused in one sentence", "[io][mutants]") {
  const scratch::folder folder;
  io::write_table(folder / "t.csv", io::table{{{"a, b", {1, 2, 3}}, {"\"c\"", {0.1, -2e-9, inf}}}});
  const std::string good = scratch::content(folder / "t.csv");
  std::mt19937_64 random(11);
  tally seen;
  for (int k = 0; k < 3000; ++k) {
    std::string bytes = good;
    for (int n = 0; n <= k % 3; ++n)
      bytes[static_cast<std::size_t>(random() % good.size())] = static_cast<char>(random());
    if (k % 5 == 0) bytes.erase(static_cast<std::size_t>(random() % good.size()));
    scratch::write(folder / "d.csv", bytes);
    const std::string said = scratch::message<std::runtime_error>([&] {
      const auto read = io::read_table(folder / "d.csv");
      for (const auto& c : read.columns()) REQUIRE(c.values.size() == read.rows());
    });
    const bool is_read = said == "no error";
    REQUIRE((is_read || scratch::mentions(said, {"pendular: table '"})));
    ++(is_read ? seen.read : seen.refused);
  }
  CHECK(seen.read > 10);
  CHECK(seen.refused > 1000);
}
