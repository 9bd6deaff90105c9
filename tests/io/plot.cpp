// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/plot.hpp>

#include <cmath>
#include <limits>

#include "scratch.hpp"

namespace io = pendular::io;

namespace {

io::plot example() {
  io::plot p{"shear_stress of 'wet' sand {x}^2 \\n \"q\" `id`", "displacement d_x (mm)", "stress \xCF\x84 (Pa)", {}};
  for (const auto style :
       {io::curve_style::lines, io::curve_style::points, io::curve_style::linespoints, io::curve_style::dashed}) {
    io::curve c{"grain_films $curve0 @x", {}, {}, style};
    for (int i = 0; i < 20; ++i) {
      c.x.push_back(i);
      c.y.push_back(i == 7 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(i) + static_cast<int>(style));
    }
    p.curves.push_back(c);
  }
  return p;
}

bool missing(const std::string& program) { return pendular::io::shell::run("command -v " + program).status != 0; }

}  // namespace

TEST_CASE("any text is one word of a shell command", "[io][plot]") {
  for (const std::string text : {"plain", "two words", "it's", "''", "$HOME `id` \"x\" \\ ; & *", "-n", ""}) {
    const auto outcome = io::shell::run("printf '%s' " + io::shell::quoted(text));
    CHECK(outcome.status == 0);
    CHECK(outcome.output == text);
  }
  CHECK(io::shell::run("exit 3").status == 3);
  CHECK(io::shell::run("no-such-program-here").status == io::shell::outcome::missing);
  CHECK(io::shell::telling_line("a\nb error c\nd\n", "error") == "b error c");
  CHECK(io::shell::telling_line("a\nlast\n\n", "error") == "last");
}

TEST_CASE("a plot becomes a PNG and an SVG that show texts as they are", "[io][plot]") {
  if (missing("gnuplot")) {
    WARN("gnuplot is not installed: not tested");
    return;
  }
  const scratch::folder folder;
  io::plot p = example();
  REQUIRE(io::draw(p, folder / "p.png"));
  const std::string png = scratch::content(folder / "p.png");
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(png.size() > 10'000);
  CHECK(png.substr(16, 8) == std::string{"\0\0\x04\xB0\0\0\x03\x20", 8});  // 1200 x 800

  p.curves[1].error.assign(20, 0.5);
  REQUIRE(io::draw(p, folder / "bars.png"));
  CHECK(scratch::content(folder / "bars.png").size() > png.size());
  p.curves[1].error.pop_back();
  CHECK_THROWS_AS(io::draw(p, folder / "bars.png"), std::invalid_argument);
  p.curves[1].error.clear();

  p.x_range = {{0.5, 30}};
  p.logarithmic_x = true;
  REQUIRE(io::draw(p, folder / "p.svg"));
  CHECK(scratch::mentions(scratch::content(folder / "p.svg"),
                          {"<svg", "shear_stress of 'wet' sand {x}^2", "grain_films $curve0 @x", "d_x (mm)"}));
  CHECK(folder.files() == 3);
}

TEST_CASE("a plot that cannot be drawn keeps its data", "[io][plot]") {
  const scratch::folder folder;
  const scratch::captured_errors errors;
  {
    const scratch::empty_search_path hidden;
    CHECK_FALSE(io::draw(example(), folder / "p.png"));
  }
  CHECK(scratch::mentions(errors.text(), {"p.png' is not drawn", "gnuplot is not installed", "p.png.gp"}));
  CHECK(scratch::mentions(scratch::content(folder / "p.png.gp"), {"\n4 2\n", "NaN", "grain_films"}));
  CHECK_FALSE(io::draw(io::plot{"", "", "", {{"nothing", {1}, {std::nan("")}}}}, folder / "n.png"));
  CHECK(scratch::mentions(errors.text(), {"n.png", "no curve has a finite point"}));
}

TEST_CASE("a failure of gnuplot is told in one line", "[io][plot]") {
  if (missing("gnuplot")) return;
  const scratch::folder folder;
  const scratch::captured_errors errors;
  io::plot p = example();
  p.x_range = {{1, 1}};
  CHECK_FALSE(io::draw(p, folder / "p.png"));
  CHECK(scratch::mentions(errors.text(), {"gnuplot says: ", "range"}));
  CHECK(errors.text().find('\n') == errors.text().size() - 1);
}

TEST_CASE("a curve needs as many x as y", "[io][plot]") {
  const scratch::folder folder;
  const io::plot p{"", "", "", {{"film", {1, 2}, {1}}}};
  CHECK(scratch::mentions(scratch::message<std::invalid_argument>([&] { io::draw(p, folder / "p.png"); }),
                          {"'film'", "2 x and 1 y"}));
}
