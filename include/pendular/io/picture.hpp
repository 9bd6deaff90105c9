// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>

#include <pendular/io/atomic_file.hpp>
#include <pendular/io/colour_map.hpp>
#include <pendular/io/number.hpp>
#include <pendular/io/pov_scene.hpp>
#include <pendular/io/shell.hpp>

namespace pendular::io {

/// A packing of spheres, z upwards, seen from the side and slightly above. The spans must outlive render().
struct picture {
  std::span<const double> x;                              // m
  std::span<const double> y;                              // m
  std::span<const double> z;                              // m
  std::span<const double> radius;                         // m
  std::span<const double> value = {};                     // one per sphere, shown by colour; empty: all alike
  std::string value_label = {};                           // with unit; Latin letters, digits, punctuation
  std::optional<std::array<double, 2>> value_range = {};  // else from the least to the greatest value
  bool section = false;                                   // only spheres centred behind the plane through the axis
  std::optional<std::array<double, 2>> axis = {};         // x and y of that axis, m; else the middle of the packing
  std::optional<std::array<double, 2>> plates = {};       // heights of a lower and an upper plate, m
  double azimuth = 0;       // of the camera: 0 looks along y, then counterclockwise seen from above, rad
  double elevation = 0.22;  // of the camera over the horizon, rad
  int width = 1200;         // pixels
  int height = 900;         // pixels
  bool keep_scene = false;  // leave the scene beside the picture, as `path`.pov
};

namespace detail {

/// POV-Ray loses precision on lengths of 1e-3, so its scene is in millimetres.
inline constexpr double millimetre = 1e3;

inline void check_picture(const picture& p) {
  const std::size_t size = p.x.size();
  if (size == 0) throw std::invalid_argument("pendular: a picture has 0 spheres; it needs at least 1");
  if (p.y.size() != size || p.z.size() != size || p.radius.size() != size ||
      (!p.value.empty() && p.value.size() != size))
    throw std::invalid_argument("pendular: a picture has " + std::to_string(size) + " x, " +
                                std::to_string(p.y.size()) + " y, " + std::to_string(p.z.size()) + " z, " +
                                std::to_string(p.radius.size()) + " radii and " + std::to_string(p.value.size()) +
                                " values; it needs as many of each");
  for (std::size_t i = 0; i < size; ++i)
    if (!std::isfinite(p.x[i] + p.y[i] + p.z[i]) || !(p.radius[i] > 0) || !std::isfinite(p.radius[i]))
      throw std::invalid_argument("pendular: sphere " + std::to_string(i) + " of a picture is at " + shortest(p.x[i]) +
                                  " " + shortest(p.y[i]) + " " + shortest(p.z[i]) + " with radius " +
                                  shortest(p.radius[i]) + "; finite numbers and a positive radius are needed");
}

inline double middle(std::span<const double> values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return 0.5 * (*least + *greatest);
}

/// The cylinder around all spheres and plates.
struct outline {
  std::array<double, 2> axis;  // x and y, m
  double radius = 0;           // m
  double bottom, top;          // m

  explicit outline(const picture& p) : axis{p.axis ? *p.axis : std::array{middle(p.x), middle(p.y)}} {
    bottom = p.plates ? (*p.plates)[0] : p.z[0];
    top = p.plates ? (*p.plates)[1] : p.z[0];
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      radius = std::max(radius, std::hypot(p.x[i] - axis[0], p.y[i] - axis[1]) + p.radius[i]);
      bottom = std::min(bottom, p.z[i] - p.radius[i]);
      top = std::max(top, p.z[i] + p.radius[i]);
    }
  }

  /// A point to the right of, above and behind the middle of the cylinder as the camera sees it, mm.
  std::array<double, 3> seen(double x, double y, double z, double azimuth) const {
    const double cosine = std::cos(azimuth), sine = std::sin(azimuth);
    return {millimetre * ((x - axis[0]) * cosine + (y - axis[1]) * sine), millimetre * (z - 0.5 * (bottom + top)),
            millimetre * ((y - axis[1]) * cosine - (x - axis[0]) * sine)};
  }
};

/// From the least to the greatest finite value, widened where that is too narrow for ticks.
inline std::array<double, 2> shown_range(const picture& p) {
  std::array<double, 2> range{HUGE_VAL, -HUGE_VAL};
  for (const double v : p.value)
    if (std::isfinite(v)) range = {std::min(range[0], v), std::max(range[1], v)};
  if (p.value_range) range = *p.value_range;
  if (!std::isfinite(range[0]) || !std::isfinite(range[1])) return {0, 1};
  const double size = std::max(std::abs(range[0]), std::abs(range[1]));
  return range[1] - range[0] > 1e-6 * size ? range : std::array{range[0], range[0] + (size > 0 ? size : 1)};
}

inline std::string pov_spheres(const picture& p, const outline& around, const std::array<double, 2>& range) {
  std::string text = "#declare grain = finish { ambient 0.26 diffuse 0.78 specular 0.18 roughness 0.04 }\n";
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const auto centre = around.seen(p.x[i], p.y[i], p.z[i], p.azimuth);
    if (p.section && centre[2] < 0) continue;
    const colour tint =
        p.value.empty() ? colour{0.80, 0.72, 0.58} : viridis((p.value[i] - range[0]) / (range[1] - range[0]));
    text += "sphere { " + pov::vector(centre) + "," + shortest(millimetre * p.radius[i]) + " pigment { srgb " +
            pov::vector(tint) + " } finish { grain } }\n";
  }
  return text;
}

inline std::string pov_plates(const picture& p, const outline& around) {
  std::string text;
  if (!p.plates) return text;
  const double thickness = 0.02 * around.radius;
  for (const double side : {-1.0, 1.0}) {
    const double height = (*p.plates)[side < 0 ? 0 : 1];
    const auto near = around.seen(around.axis[0], around.axis[1], height, 0);
    const auto far = around.seen(around.axis[0], around.axis[1], height + side * thickness, 0);
    text += "cylinder { " + pov::vector(near) + ", " + pov::vector(far) + ", " +
            shortest(1.04 * millimetre * around.radius) + (p.section ? " clipped_by { plane { -z, 0 } }" : "") +
            " pigment { srgb 0.80 } finish { ambient 0.2 diffuse 0.7 } }\n";
  }
  return text;
}

inline std::string pov_scene(const picture& p) {
  check_picture(p);
  const outline around{p};
  const auto range = shown_range(p);
  const double aspect = static_cast<double>(p.width) / p.height;
  const double half_width = 1.04 * millimetre * around.radius;
  const double half_height = 0.5 * millimetre * (around.top - around.bottom);
  const double bar = p.value.empty() ? 0 : 0.25;  // width of the colour bar, picture heights
  const double lift = p.section ? 0.5 * half_width * std::sin(p.elevation) : 0;  // what is cut off below
  const double half_seen = half_height * std::cos(p.elevation) + half_width * std::sin(p.elevation) - lift;
  const double nearness = 1 + 0.3 * half_width / (pov::camera::focal_length * std::max(half_seen, half_width));
  const double height = 2.16 * nearness * std::max(half_seen, half_width / (aspect - bar));
  const pov::camera view{aspect, p.elevation, height, 0.5 * bar * height, lift};
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 charset utf8 }\nbackground { rgb 1 }\n" + view.text() +
         pov::lights(view.distance()) + pov_spheres(p, around, range) + pov_plates(p, around) +
         (p.value.empty() ? "" : pov::colour_bar{range, p.value_label, view}.text());
}

}  // namespace detail

/// Ray-traces `p` by POV-Ray into the PNG file `path`. When POV-Ray is missing or fails, leaves the scene in
/// `path`.pov, says so in one line on standard error and returns false. Throws std::invalid_argument when the spheres
/// cannot be drawn, std::runtime_error when `path` is unwritable.
inline bool render(const picture& p, const std::filesystem::path& path) {
  const auto target = std::filesystem::absolute(path);
  const auto folder = target.parent_path();
  // POV-Ray writes only into its working folder and splits arguments at blanks, hence plain names there.
  const std::string name = "povray-" + std::to_string(::getpid());
  const auto scene = folder / (name + ".pov"), image = folder / (name + ".png");
  auto kept = target;
  kept += ".pov";
  atomic_file file{scene};
  file.write(detail::pov_scene(p));
  file.commit();

  const auto outcome =
      shell::run("cd " + shell::quoted(folder.string()) + " && povray +I" + name + ".pov +O" + name + ".png +W" +
                 std::to_string(p.width) + " +H" + std::to_string(p.height) + " +FN +A0.1 +AM2 +R2 -D -GA -V");
  std::error_code error, ignored;
  if (outcome.status == 0) std::filesystem::rename(image, target, error);
  const bool drawn = outcome.status == 0 && !error;
  if (!drawn) std::filesystem::remove(image, ignored);
  if (drawn && !p.keep_scene) std::filesystem::remove(scene, ignored);
  else std::filesystem::rename(scene, kept, ignored);
  if (drawn) return true;
  const bool missing = outcome.status == shell::outcome::missing;
  std::cerr << "pendular: '" << path.string() << "' is not drawn: "
            << (missing ? "POV-Ray is not installed (package povray)"
                        : "POV-Ray says: " + shell::telling_line(outcome.output, "Error"))
            << "; its scene is in '" << kept.string() << "'\n";
  return false;
}

}  // namespace pendular::io
