// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <pendular/io/atomic_file.hpp>
#include <pendular/io/number.hpp>
#include <pendular/io/shell.hpp>

namespace pendular::io {

enum class curve_style { lines, points, linespoints, dashed };

struct curve {
  std::string label;  // empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;  // a value that is not finite leaves a gap
  curve_style style = curve_style::lines;
  std::optional<std::size_t> colour = {};  // place in the palette, for curves that belong together; else its own
  std::vector<double> error = {};          // half the height of a bar at each point; empty: no bars
};

/// Texts are UTF-8 and shown as they are: no character is markup.
struct plot {
  std::string title;
  std::string x_label;  // with unit
  std::string y_label;
  std::vector<curve> curves;
  std::optional<std::array<double, 2>> x_range = {};
  std::optional<std::array<double, 2>> y_range = {};
  bool logarithmic_x = false;
  bool logarithmic_y = false;
};

namespace detail {

/// Okabe and Ito's palette with a grey for its yellow: told apart also by the colour-blind.
inline constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                    "#56B4E9", "#E69F00", "#000000", "#888888"};

/// `text` as a gnuplot string, in which nothing is special; a line break would end the command.
inline std::string gnuplot_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string{"''"} : std::string(1, c == '\n' ? ' ' : c);
  return quoted + "'";
}

inline bool drawable(const curve& c) {
  for (std::size_t i = 0; i < c.x.size(); ++i)
    if (std::isfinite(c.x[i]) && std::isfinite(c.y[i])) return true;
  return false;
}

/// x, y and half the height of the bar, if there are bars.
inline std::string gnuplot_point(const curve& c, std::size_t i) {
  const bool there = std::isfinite(c.x[i]) && std::isfinite(c.y[i]);
  std::string line = there ? shortest(c.x[i]) + " " + shortest(c.y[i]) : std::string{"NaN NaN"};
  if (!c.error.empty()) line += " " + shortest(std::isfinite(c.error[i]) ? c.error[i] : 0);
  return line + "\n";
}

inline std::string gnuplot_data(const curve& c, std::size_t number) {
  std::string block = "$curve" + std::to_string(number) + " << end_of_curve\n";
  for (std::size_t i = 0; i < c.x.size(); ++i) block += gnuplot_point(c, i);
  return block + "end_of_curve\n";
}

inline std::string gnuplot_style(const curve& c, std::size_t number) {
  static constexpr std::array markers{7, 5, 9, 13, 11, 6, 4, 8};  // filled ones first
  const std::size_t place = c.colour.value_or(number) % palette.size();
  const std::string colour = std::string{" linecolor rgb '"} + palette[place] + "'";
  const std::string marker = " pointsize 1.3 pointtype " + std::to_string(markers[number % markers.size()]);
  switch (c.style) {
  case curve_style::points:
    return "with points" + colour + marker;
  case curve_style::linespoints:
    return "with linespoints linewidth 2.5" + colour + marker;
  case curve_style::dashed:
    return "with lines linewidth 2.5 dashtype (14,9)" + colour;
  default:
    return "with lines linewidth 2.5" + colour;
  }
}

inline std::string gnuplot_bars(const curve& c, std::size_t number) {
  return std::string{"with yerrorbars linewidth 2 pointsize 0 linecolor rgb '"} +
         palette[c.colour.value_or(number) % palette.size()] + "' notitle";
}

inline std::string gnuplot_axis(const std::string& axis, const std::string& label, bool logarithmic,
                                const std::optional<std::array<double, 2>>& range) {
  std::string text = "set " + axis + "label " + gnuplot_quoted(label) + "\n";
  if (logarithmic) text += "set logscale " + axis + "\n";
  if (range) text += "set " + axis + "range [" + shortest((*range)[0]) + ":" + shortest((*range)[1]) + "]\n";
  return text;
}

inline std::string gnuplot_commands(const plot& p, bool svg, const std::filesystem::path& output) {
  std::string text = std::string{"set encoding utf8\nset terminal "} +
                     (svg ? "svg size 1200,800 background rgb 'white'" : "pngcairo size 1200,800") +
                     " font 'DejaVu Sans,17' noenhanced\nset output " + gnuplot_quoted(output.string()) + "\n";
  text += "set border 3 linewidth 1.5 linecolor rgb '#404040'\nset tics nomirror out\n"
          "set grid linetype 1 linewidth 1 linecolor rgb '#DDDDDD'\nset style fill solid\n"
          "set key below center horizontal Left reverse samplen 2.5 spacing 1.2 height 0.8\n"
          "set lmargin 13\nset rmargin 4\nset format '%g'\n";
  text += "set title " + gnuplot_quoted(p.title) + " font 'DejaVu Sans,20'\n";
  text += gnuplot_axis("x", p.x_label, p.logarithmic_x, p.x_range);
  text += gnuplot_axis("y", p.y_label, p.logarithmic_y, p.y_range);
  std::string drawing;
  for (std::size_t i = 0; i < p.curves.size(); ++i) {
    const curve& c = p.curves[i];
    if (!drawable(c)) continue;
    text += gnuplot_data(c, i);
    const std::string data = "$curve" + std::to_string(i);
    if (!c.error.empty()) drawing += (drawing.empty() ? "plot " : ", ") + data + " using 1:2:3 " + gnuplot_bars(c, i);
    drawing += (drawing.empty() ? "plot " : ", ") + data + " using 1:2 " + gnuplot_style(c, i) +
               (c.label.empty() ? " notitle" : " title " + gnuplot_quoted(c.label));
  }
  return drawing.empty() ? drawing : text + drawing + "\n";
}

inline void expect_equal_lengths(const curve& c) {
  const auto expect = [&](std::size_t count, const char* what) {
    if (count != c.x.size())
      throw std::invalid_argument("pendular: curve '" + c.label + "' has " + std::to_string(c.x.size()) + " x and " +
                                  std::to_string(count) + what + "; it needs as many of both");
  };
  expect(c.y.size(), " y values");
  if (!c.error.empty()) expect(c.error.size(), " error bars");
}

}  // namespace detail

/// Draws `p` by gnuplot as 1200 x 800 pixels: SVG when `path` ends in .svg, else PNG. When gnuplot is missing or
/// fails, leaves the commands with all data in `path`.gp, says so in one line on standard error and returns false.
/// Throws std::invalid_argument when x, y or bars of a curve differ in length, std::runtime_error when `path` is
/// unwritable.
inline bool draw(const plot& p, const std::filesystem::path& path) {
  for (const curve& c : p.curves) detail::expect_equal_lengths(c);
  const auto target = std::filesystem::absolute(path);
  auto script = target;
  script += ".gp";
  const std::string commands = detail::gnuplot_commands(p, target.extension() == ".svg", target);
  if (commands.empty()) {
    std::cerr << "pendular: '" << path.string() << "' is not drawn: no curve has a finite point\n";
    return false;
  }
  atomic_file file{script};
  file.write(commands);
  file.commit();

  const auto outcome = shell::run("gnuplot " + shell::quoted(script.string()));
  std::error_code error;
  if (outcome.status == 0 && std::filesystem::file_size(target, error) > 0 && !error) {
    std::filesystem::remove(script, error);
    return true;
  }
  const bool missing = outcome.status == shell::outcome::missing;
  std::cerr << "pendular: '" << path.string() << "' is not drawn: "
            << (missing ? "gnuplot is not installed (package gnuplot-nox)"
                        : "gnuplot says: " + shell::telling_line(outcome.output, "line"))
            << "; its data are in '" << script.string() << "'\n";
  return false;
}

}  // namespace pendular::io
