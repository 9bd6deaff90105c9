// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/how-to/paraview.md.
#include <pendular/io/collection.hpp>
#include <pendular/io/vtk.hpp>
#include <pendular/pendular.hpp>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using namespace pendular;

// [grains]
template <class System>
void write_grains(const System& s, const std::filesystem::path& path) {
  const auto position = s.particles().template get<column::position>();
  const auto velocity = s.particles().template get<column::velocity>();
  const auto radius = s.particles().template get<column::radius>();
  std::vector<double> x, y, z, speed;
  for (std::size_t k = 0; k < position.size(); ++k) {
    x.push_back(position[k].x), y.push_back(position[k].y), z.push_back(position[k].z);
    speed.push_back(norm(velocity[k]));
  }
  io::write_points(path, x, y, z, {io::field("radius", 1, radius), io::field("speed", 1, speed)});
}
// [/grains]

// [bridges]
template <class System>
void write_bridges(const System& s, const std::filesystem::path& path) {
  const pair_view view = s.view();
  std::vector<double> x, y, z, volume;
  for (const vector& p : view.position) x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
  std::vector<std::array<std::int64_t, 2>> lines;
  for (std::size_t p = 0; p < view.pairs; ++p) {
    if (!s.bridges().is_bonded(p)) continue;
    lines.push_back({view.first[p], view.second[p]});
    volume.push_back(s.bridges().book().bonds()[p]);
  }
  io::write_lines(path, x, y, z, lines, {}, {io::field("volume", 1, volume)});
}
// [/bridges]

int main() {
  const liquid l{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}};
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.8}}, l,
                     boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                     half_step_velocity_verlet{4e-6, {0, 0, -9.81}}};
  for (int k = 0; k < 5; ++k) s.add({.position = {0, 0, 0.5e-3 + 1e-3 * k}, .radius = 0.5e-3, .density = 2700});
  s.distribute_liquid(4 * 0.01 * 0.125e-9);
  // [series]
  const std::filesystem::path folder = "docs_output/paraview";
  io::collection series(folder / "grains.pvd");
  for (int frame = 0; frame < 4; ++frame) {
    const auto file = folder / ("grains_" + std::to_string(frame) + ".vtp");
    write_grains(s, file);
    write_bridges(s, folder / ("bridges_" + std::to_string(frame) + ".vtp"));
    series.add(s.time(), file);
    s.run(500);
  }
  // [/series]
  return series.entries().size() == 4 && std::filesystem::file_size(folder / "bridges_3.vtp") > 0 ? EXIT_SUCCESS
                                                                                                  : EXIT_FAILURE;
}
