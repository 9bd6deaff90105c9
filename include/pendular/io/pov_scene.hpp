// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <string_view>

#include <pendular/io/colour_map.hpp>
#include <pendular/io/number.hpp>

/// Pieces of POV-Ray scenes: text in its scene language. The x axis is to the right, y upwards, z away from the camera.
namespace pendular::io::pov {

inline std::string vector(const std::array<double, 3>& v) {
  return "<" + shortest(v[0]) + "," + shortest(v[1]) + "," + shortest(v[2]) + ">";
}

inline std::string quoted(std::string_view text) {
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    safe += c == '\n' ? ' ' : c;
  }
  return safe + "\"";
}

/// A camera that looks down at the origin, and what its picture covers.
struct camera {
  double aspect;     // width of the picture over its height
  double elevation;  // over the horizon, rad
  double height;     // of the picture at the origin, scene units
  double shift;      // to the right, scene units
  double lift;       // upwards, scene units

  static constexpr double focal_length = 3.4;  // picture heights: a telephoto lens, verticals stay upright

  double distance() const { return focal_length * height; }

  /// Puts what was built around a camera at the origin that looks along z where this one stands.
  std::string transform() const {
    return " translate -" + shortest(distance()) + "*z rotate " + shortest(elevation * 180 / std::numbers::pi) +
           "*x translate " + vector({shift, lift, 0}) + " ";
  }

  std::string text() const {
    return "camera { location 0 direction " + shortest(focal_length) + "*z up y right " + shortest(aspect) + "*x" +
           transform() + "}\n";
  }
};

/// One soft light over the left shoulder and a weak one from the right that fills the shadows, at `distance`.
inline std::string lights(double distance) {
  const auto at = [distance](double right, double up, double away) {
    return vector({distance * right, distance * up, distance * away});
  };
  const std::string side = shortest(0.35 * distance);
  return "light_source { " + at(-0.75, 1.1, -0.9) + " rgb 1 area_light " + side + "*x, " + side +
         "*z, 7, 7 adaptive 1 circular orient }\nlight_source { " + at(0.9, 0.5, -1.0) + " rgb 0.45 shadowless }\n";
}

/// Round steps (1, 2 or 5 times a power of ten) that divide `range` in three to seven.
inline double tick_step(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 4)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (range / (factor * power) <= 6.5) return factor * power;
  return 10 * power;
}

inline std::string tick_label(double value, double step) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.6g", std::abs(value) < 1e-6 * step ? 0.0 : value);
  return text.data();
}

/// A scale of viridis with numbers and a title, fixed to the right edge of the picture. It is unshaded, and so would be
/// what follows it in the scene: put it last.
struct colour_bar {
  std::array<double, 2> range;
  std::string_view title;
  camera view;

  std::string text() const {
    // The union stands halfway to what the camera looks at, before all of it.
    return "#default { finish { ambient 0 diffuse 0 emission 1 } }\nunion {\n" + scale() + ticks() + heading() +
           "no_shadow no_reflection translate " + shortest(camera::focal_length) + "*z scale " +
           shortest(0.5 * view.height) + view.transform() + "}\n";
  }

 private:
  // lengths in picture heights
  static constexpr double half_length = 0.31, width = 0.032, text_height = 0.036;
  static constexpr int slices = 100;
  static constexpr const char* ink = " pigment { srgb 0.12 } }\n";

  double left() const { return 0.5 * view.aspect - 0.21; }

  static std::string box(double x0, double y0, double x1, double y1, double depth) {
    return "box { " + vector({x0, y0, depth}) + ", " + vector({x1, y1, depth + 1e-3});
  }

  static std::string letters(std::string_view text) { return "text { internal 2 " + pov::quoted(text) + " 0.01, 0 "; }

  std::string scale() const {
    static constexpr double edge = 0.0025;
    const double x = left();
    std::string text = box(x - edge, -half_length - edge, x + width + edge, half_length + edge, 0.002) + ink;
    for (int i = 0; i < slices; ++i)
      text += box(x, half_length * (2.0 * i / slices - 1), x + width, half_length * (2.0 * (i + 1) / slices - 1), 0) +
              " pigment { srgb " + vector(viridis((i + 0.5) / slices)) + " } }\n";
    return text;
  }

  std::string ticks() const {
    const double right = left() + width, step = tick_step(range[1] - range[0]);
    std::string text;
    for (double tick = std::ceil(range[0] / step - 1e-6); tick * step <= range[1] + 1e-6 * step; ++tick) {
      const double y = half_length * (2 * (tick * step - range[0]) / (range[1] - range[0]) - 1);
      text += box(right, y - 0.001, right + 0.011, y + 0.001, 0) + ink + letters(tick_label(tick * step, step)) +
              "scale " + shortest(text_height) + " translate " + vector({right + 0.018, y - 0.35 * text_height, 0}) +
              ink;
    }
    return text;
  }

  std::string heading() const {
    if (title.empty()) return {};
    return "#declare heading = " + letters(title) +
           "}\nobject { heading translate -0.5*max_extent(heading).x*x scale " + shortest(text_height) +
           " rotate 90*z translate " + vector({0.5 * view.aspect - 0.02, 0, 0}) + ink;
  }
};

}  // namespace pendular::io::pov
