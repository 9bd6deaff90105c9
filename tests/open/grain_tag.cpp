// SPDX-License-Identifier: BSD-3-Clause
// Tags of a user's own on grains, written from outside: they follow their grains, are in checkpoints and seen in ParaView.
#include "../catch.hpp"

#include <pendular/io/checkpoint.hpp>
#include <pendular/io/grain_fields.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/io/vtk.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

using namespace pendular;

namespace {

// [tags]
struct temperature {
  using type = double;
  static constexpr std::string_view label = "temperature", unit = "K";
};
struct batch {
  using type = std::int64_t;
  static constexpr std::string_view label = "batch", unit = "1";
};
struct heat_flux {
  using type = vector;
  static constexpr std::string_view label = "heat_flux", unit = "W/m2";
};
// [/tags]

auto hot_grains() {
  // [system]
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6},
                     tags<temperature, batch, heat_flux>{}};
  for (int k = 0; k < 50; ++k) {
    s.add({.position = {1e-3 * (k * 7 % 50), 0, 1e-3 * (k * 3 % 5)}, .radius = 0.4e-3, .density = 2600});
    s.particles().get<temperature>()[s.particles().row_of(k)] = 300 + k;
  }
  // [/system]
  for (std::int64_t k = 0; k < 50; ++k) {
    const std::size_t row = s.particles().row_of(k);
    s.particles().get<batch>()[row] = k * k;
    s.particles().get<heat_flux>()[row] = {0.5 * static_cast<double>(k), 0, -1};
  }
  return s;
}

template <class System>
void expect_tags(const System& s, std::int64_t without) {
  for (std::int64_t k = 0; k < 50; ++k) {
    if (k == without) continue;
    const std::size_t row = s.particles().row_of(k);
    CHECK(s.particles().template get<temperature>()[row] == 300.0 + static_cast<double>(k));
    CHECK(s.particles().template get<batch>()[row] == k * k);
    CHECK(s.particles().template get<heat_flux>()[row] == vector{0.5 * static_cast<double>(k), 0, -1});
  }
}

}  // namespace

TEST_CASE("tags follow their grains through lists, additions, removals and checkpoints") {
  auto s = hot_grains();
  s.run(10);
  expect_tags(s, -1);
  s.remove(std::vector<std::int64_t>{17});
  s.add({.position = {0, 1, 0}, .radius = 0.4e-3, .density = 2600});
  s.run(10);
  expect_tags(s, 17);
  CHECK(s.particles().get<temperature>()[s.particles().row_of(50)] == 0);
  s.canonicalise();
  const auto file = std::filesystem::temp_directory_path() / "pendular_tags.state";
  {
    io::checkpoint_writer out(file);
    io::save(out, s);
    out.commit();
  }
  pendular::system other{s.contact_material(), s.walls(), s.integrator(), tags<temperature, batch, heat_flux>{}};
  io::load(io::checkpoint_reader(file), other);
  expect_tags(other, 17);
  std::filesystem::remove(file);
}

TEST_CASE("a file for ParaView has every column under its label and unit") {
  auto s = hot_grains();
  s.start();
  const auto file = std::filesystem::temp_directory_path() / "pendular_tags.vtp";
  io::write_grains(file, s.particles());
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const std::string name :
       {"temperature (K)", "batch", "heat_flux (W/m2)", "radius (m)", "velocity (m/s)", "id"}) {
    CHECK(text.find("Name=\"" + name + "\"") != std::string::npos);
  }
  const auto fields = io::grain_fields(s.particles());
  for (const io::field& f : fields) {
    if (f.name == "temperature (K)") CHECK((f.components == 1 && f.values.size() == 50 && f.values[49] == 349));
    if (f.name == "heat_flux (W/m2)") CHECK((f.components == 3 && f.values.size() == 150 && f.values[3] == 0.5));
    if (f.name == "batch") CHECK(f.values[7] == 49);
  }
  std::filesystem::remove(file);
}
