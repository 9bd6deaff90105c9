// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/how-to/resume.md.
// [head]
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/pendular.hpp>
// [/head]

#include <cstdio>
#include <cstdlib>
#include <filesystem>

using namespace pendular;

// [scene]
auto empty_scene() {
  const material m{normal::linear{1e3}, damping::viscous{0.8}, friction::viscous_coulomb{1.0, 0.4}, energy_book{}};
  const liquid l{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}};
  return pendular::system{m, l, boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                          half_step_velocity_verlet{4e-6, {0, 0, -9.81}}};
}
// [/scene]

// [save]
template <class System>
void save_to(const std::filesystem::path& path, System& s) {
  s.canonicalise();
  io::checkpoint_writer out(path);
  out.put("my.label", std::string_view{"a column of grains"});
  io::save(out, s);
  out.commit();
}
// [/save]

// [load]
auto resumed(const std::filesystem::path& path) {
  const io::checkpoint_reader in(path);
  auto s = empty_scene();
  io::load(in, s);
  return s;
}
// [/load]

int main() {
  const std::filesystem::path path = "docs_output/resume/column.bin";
  auto s = empty_scene();
  for (int k = 0; k < 20; ++k) {
    const double side = 1e-4 * (k % 3), height = 0.5e-3 + 1.02e-3 * k;
    s.add({.position = {side, 0, height}, .radius = 0.5e-3, .density = 2700, .velocity = {0, 0.01, 0}});
  }
  s.distribute_liquid(20 * 0.01 * 0.125e-9);
  s.run(2000);
  save_to(path, s);
  s.run(2000);
  auto again = resumed(path);
  again.run(2000);
  bool same = again.step_count() == s.step_count() && again.bridges().count() == s.bridges().count();
  for (std::size_t row = 0; row < 20; ++row) {
    same &= s.particles().get<column::position>()[row] == again.particles().get<column::position>()[row];
    same &= s.particles().get<column::velocity>()[row] == again.particles().get<column::velocity>()[row];
  }
  std::printf("step %lld, same bits: %s\n", static_cast<long long>(again.step_count()), same ? "yes" : "no");
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
