// SPDX-License-Identifier: BSD-3-Clause
// States of a system whose checksum is right and whose content is not: refused in a sentence with the system as it was, or
// a state that keeps its liquid and runs on.
#include "../io/checkpoint_bytes.hpp"
#include "../io/scratch.hpp"
#include "../physics/scenes.hpp"

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/liquid/source/evaporation.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace pendular;
using namespace scenes;
using namespace checkpoint_bytes;

namespace {

auto empty_scene() {
  using boundary::plane;
  using boundary::wall;
  return pendular::system{
      material{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}},
      liquid{fluid::water(), capillary::bagheri{}, rupture::willett{}, protocol::neighbours{},
             source::evaporation{1e-9, 1e-9, 50}},
      boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}},
                      wall{plane{{0, 0, 5e-3}, {0, 0, -1}}, boundary::servo_stress{20, 1e-6, 1e-5, 1e-3}}},
      velocity_verlet{1e-6, {0, 0, -9.81}}, run_options{.force = true}};
}

/// Three grains with friction springs, bridges between them and to the floor, films and vapour.
std::string good_state(const std::filesystem::path& path) {
  auto s = empty_scene();
  const double r = 0.5e-3;
  for (int k = 0; k < 3; ++k) {
    s.add({.position = {0.999 * 2 * r * k, 0, 0.999 * r}, .radius = r, .density = 2600, .velocity = {0, 0.01, 0}});
  }
  s.distribute_liquid(4e-12);
  s.exchange("syringe", [](auto& door) { door.wet_grain(1, 1e-14); });
  s.drive(2);
  s.run(200);
  s.canonicalise();
  io::checkpoint_writer out(path);
  io::save(out, s);
  out.commit();
  const std::string bytes = scratch::content(path);
  return bytes.substr(0, bytes.size() - tail);
}

struct tally {
  int refused = 0, read = 0;
};

/// Reads the file; what is taken must keep its books and run.
void expect_refused_or_sound(const std::filesystem::path& path, const std::string& what, tally& seen) {
  INFO(what);
  auto s = empty_scene();
  std::string said;
  try {
    io::load(io::checkpoint_reader(path), s);
  } catch (const std::runtime_error& e) {
    said = e.what();
  } catch (const std::invalid_argument& e) {
    said = e.what();
  }
  if (!said.empty()) {
    CHECK((said.find("see docs/") != std::string::npos && said.find('\n') == std::string::npos));
    CHECK((s.particles().size() == 0 && s.bridges().book().introduced() == 0));
    ++seen.refused;
    return;
  }
  ++seen.read;
  const ledger& book = s.bridges().book();
  REQUIRE(book.total() == within(1e-6, book.here()));
  try {
    s.run(3);
    CHECK(book.total() == within(1e-6, book.here()));
  } catch (const run_error& e) {
    CHECK(std::string(e.what()).find("see docs/") != std::string::npos);
  }
}

template <class T>
void change(field& f, std::size_t place, T value) {
  std::memcpy(f.bytes.data() + place * sizeof(T), &value, sizeof value);
}

}  // namespace

TEST_CASE("every record of a state without an element, with one too many and missing is refused") {
  const scratch::folder folder;
  const std::string good = good_state(folder / "good");
  const fields all = *decoded(good);
  tally seen;
  const auto try_it = [&](const fields& f, const std::string& what) {
    scratch::write(folder / "d", encoded(f, good));
    expect_refused_or_sound(folder / "d", what, seen);
  };
  try_it(all, "as it was");
  REQUIRE(seen.read == 1);
  for (const auto& [name, f] : all) {
    fields without = all;
    without.erase(name);
    try_it(without, name + " is missing");
    if (f.type != 1 && f.type != 4) continue;
    fields shorter = all, longer = all;
    if (!f.bytes.empty()) {
      shorter[name].bytes.resize(f.bytes.size() - 8);
      try_it(shorter, name + " lacks its last element");
    }
    longer[name].bytes += std::string(8, '\1');
    try_it(longer, name + " has one element too many");
  }
  CHECK(seen.read <= 2);
  CHECK(seen.refused > 80);
}

TEST_CASE("numbers without meaning in any place of a state are refused, or the state is sound") {
  const scratch::folder folder;
  const std::string good = good_state(folder / "good");
  const fields all = *decoded(good);
  tally seen;
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const auto& field : all) {
    const auto& name = field.first;  // bindings are not captured by clang 14
    const auto& f = field.second;
    const std::size_t count = f.bytes.size() / 8;
    for (std::size_t place = 0; place < count; ++place) {
      const auto try_it = [&](auto value) {
        fields changed = all;
        change(changed[name], place, value);
        scratch::write(folder / "d", encoded(changed, good));
        expect_refused_or_sound(folder / "d", name + ", place " + std::to_string(place), seen);
      };
      if (f.type == 1) {
        for (const double v : {nan, inf, -1.0, 0.0, 1e300, 3e-13}) try_it(v);
      } else if (f.type == 4) {
        for (const std::int64_t v :
             {std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, std::int64_t{7},
              std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()})
          try_it(v);
      }
    }
  }
  CHECK(seen.refused > 300);
  CHECK(seen.read > 100);
}
