// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/picture.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "scratch.hpp"

namespace io = pendular::io;

namespace {

/// Four grains around the axis (0.01, 0.02), named by where they are as seen along y.
const std::vector<double> x{0.012, 0.008, 0.010, 0.010}, y{0.020, 0.020, 0.022, 0.018}, z{0.001, 0.001, 0.003, 0.003},
    radius{0.0011, 0.0012, 0.0013, 0.0014}, value{0, 1, 2, 3};

io::picture example() {
  io::picture p{x, y, z, radius};
  p.value = value;
  p.value_label = "displacement \"d_x\" (mm)";
  p.plates = {{0, 0.005}};
  p.width = 200;
  p.height = 150;
  return p;
}

bool shows(const std::string& scene, const std::string& grain_radius) {
  return scene.find(">," + grain_radius + " pigment") != std::string::npos;
}

/// How far right of the axis the camera sees that grain, mm.
double right_of_axis(const io::picture& p, const std::string& grain_radius) {
  const std::string scene = io::detail::pov_scene(p);
  return std::stod(scene.substr(scene.rfind('<', scene.find(">," + grain_radius + " pigment")) + 1));
}

}  // namespace

TEST_CASE("the colours run through viridis", "[io][picture]") {
  // matplotlib's table, entries 0, 64, 128 and 255
  const auto near = [](const io::colour& a, const io::colour& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 0.01;
  };
  CHECK(near(io::viridis(0), {0.267004, 0.004874, 0.329415}));
  CHECK(near(io::viridis(64 / 255.0), {0.229739, 0.322361, 0.545706}));
  CHECK(near(io::viridis(128 / 255.0), {0.127568, 0.566949, 0.550556}));
  CHECK(near(io::viridis(1), {0.993248, 0.906157, 0.143936}));
  CHECK(io::viridis(-5) == io::viridis(0));
  CHECK(io::viridis(7) == io::viridis(1));
  CHECK(near(io::viridis(std::nan("")), {0.6, 0.6, 0.6}));
}

TEST_CASE("a section shows the grains behind the axis, from any side", "[io][picture]") {
  io::picture p = example();
  p.axis = {{0.01, 0.02}};
  std::string scene = io::detail::pov_scene(p);
  CHECK((shows(scene, "1.1") && shows(scene, "1.2") && shows(scene, "1.3") && shows(scene, "1.4")));
  p.section = true;
  scene = io::detail::pov_scene(p);
  CHECK((shows(scene, "1.3") && !shows(scene, "1.4")));
  p.azimuth = std::numbers::pi / 2;  // looks along -x
  scene = io::detail::pov_scene(p);
  CHECK((shows(scene, "1.2") && !shows(scene, "1.1")));
  p.section = false;
  CHECK((right_of_axis(p, "1.3") > 1.9 && right_of_axis(p, "1.4") < -1.9));
  p.azimuth = 0;
  CHECK((right_of_axis(p, "1.1") > 1.9 && right_of_axis(p, "1.2") < -1.9));
}

TEST_CASE("the ticks of the colour bar are round and inside the range", "[io][picture]") {
  for (const double range : {0.37, 1.0, 2.0, 3.1, 7.0, 10.0, 123.0, 5e-5}) {
    const double step = io::pov::tick_step(range);
    CHECK(range / step >= 2);
    CHECK(range / step <= 7);
    const double leading = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    CHECK((std::abs(leading - 1) < 1e-9 || std::abs(leading - 2) < 1e-9 || std::abs(leading - 5) < 1e-9));
  }
  io::picture p = example();
  p.value_range = {{-1, 1}};
  CHECK(scratch::mentions(io::detail::pov_scene(p), {"\"-1\"", "\"-0.5\"", "\"0\"", "\"0.5\"", "\"1\""}));
  for (const double level : {0.0, 3e-7, -1e300}) {
    const std::vector<double> same(4, level);
    p.value = same;
    p.value_range.reset();
    CHECK(io::detail::pov_scene(p).size() < 100'000);
  }
}

TEST_CASE("a picture is rendered and leaves only what is asked for", "[io][picture]") {
  if (io::shell::run("command -v povray").status != 0) {
    WARN("POV-Ray is not installed: not tested");
    return;
  }
  const scratch::folder folder;
  io::picture p = example();
  REQUIRE(io::render(p, folder / "p.png"));
  const std::string png = scratch::content(folder / "p.png");
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(png.substr(16, 8) == std::string{"\0\0\0\xC8\0\0\0\x96", 8});  // 200 x 150
  CHECK(png.size() > 2'000);
  CHECK(folder.files() == 1);
  p.keep_scene = true;
  REQUIRE(io::render(p, folder / "p.png"));
  CHECK(std::filesystem::exists(folder / "p.png.pov"));
  CHECK(folder.files() == 2);
}

TEST_CASE("a picture that cannot be rendered keeps its scene", "[io][picture]") {
  const scratch::folder folder;
  const scratch::captured_errors errors;
  const scratch::empty_search_path hidden;
  CHECK_FALSE(io::render(example(), folder / "p.png"));
  CHECK(scratch::mentions(errors.text(), {"p.png' is not drawn", "POV-Ray is not installed", "p.png.pov"}));
  CHECK(shows(scratch::content(folder / "p.png.pov"), "1.3"));
  CHECK(folder.files() == 1);
}

TEST_CASE("spheres that cannot be drawn are refused", "[io][picture]") {
  const scratch::folder folder;
  const auto said = [&](const io::picture& p) {
    return scratch::message<std::invalid_argument>([&] { io::render(p, folder / "p.png"); });
  };
  CHECK(scratch::mentions(said({}), {"0 spheres"}));
  io::picture p = example();
  p.value = std::span{value}.first(3);
  CHECK(scratch::mentions(said(p), {"4 x", "3 values"}));
  const std::vector<double> flat{0.001, 0, 0.001, 0.001}, lost{0, 0, std::nan(""), 0};
  p = example();
  p.radius = flat;
  CHECK(scratch::mentions(said(p), {"sphere 1", "radius 0"}));
  p = example();
  p.z = lost;
  CHECK(scratch::mentions(said(p), {"sphere 2", "nan"}));
  CHECK(folder.files() == 0);
}
