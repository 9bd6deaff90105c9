// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.hpp"

#include <pendular/io/collection.hpp>
#include <pendular/io/picture.hpp>
#include <pendular/io/vtk.hpp>

#include <algorithm>
#include <cstdio>
#include <string>

namespace examples {

namespace {
std::string numbered(const char* stem, int number) {
  char name[64];
  std::snprintf(name, sizeof name, "%s_%04d.vtp", stem, number);
  return name;
}
}  // namespace

void write_snapshot(const job_options& o, const snapshot& s, int number) {
  using pendular::io::field;
  const auto displacement =
      pendular::io::vector_field("displacement", s.displacement_x, s.displacement_y, s.displacement_z);
  pendular::io::write_points(o.output / numbered("grains", number), s.x, s.y, s.z,
                             {field("radius", 1, s.radius), displacement, field("liquid", 1, s.liquid)});
  pendular::io::write_lines(
      o.output / numbered("bonds", number), s.x, s.y, s.z, s.bonds, {},
      {field("force", 1, s.bond_force), field("volume", 1, s.bond_volume), field("gap", 1, s.bond_gap)});
  for (const char* stem : {"grains", "bonds"}) {
    const auto path = o.output / (std::string(stem) + ".pvd");
    using pendular::io::collection;
    collection series = number == 0 ? collection(path, {}) : collection(path);
    series.add(s.time, o.output / numbered(stem, number));
  }
}

void draw_sample(const job_options& o, const snapshot& s, double lid_height) {
  if (!o.pictures) return;
  std::vector<double> millimetres(s.displacement.size());
  std::transform(s.displacement.begin(), s.displacement.end(), millimetres.begin(), [](double d) { return 1e3 * d; });
  pendular::io::picture p{s.x, s.y, s.z, s.radius};
  p.value = millimetres;
  p.value_label = "displacement (mm)";
  p.plates = {0.0, lid_height};
  p.axis = {0.0, 0.0};
  pendular::io::render(p, o.output / "sample.png");
  p.section = true;
  pendular::io::render(p, o.output / "section.png");
}

}  // namespace examples
