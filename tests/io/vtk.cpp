// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/vtk.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "scratch.hpp"

namespace io = pendular::io;

namespace {

/// A reader of raw appended VTK XML of its own: finds arrays by attribute text, knows nothing of the writer.
class parsed_vtp {
 public:
  explicit parsed_vtp(const std::filesystem::path& path) : bytes_{scratch::content(path)} {
    const auto appended = bytes_.find("<AppendedData encoding=\"raw\">");
    REQUIRE(appended != std::string::npos);
    head_ = bytes_.substr(0, appended);
    data_ = bytes_.find('_', appended) + 1;
  }

  const std::string& head() const { return head_; }

  std::string attribute(const std::string& tag, const std::string& name) const {
    const auto begin = head_.find("<" + tag + " ");
    REQUIRE(begin != std::string::npos);
    return attribute_at(begin, name);
  }

  /// The array called `name` in the first element `section`.
  template <class T>
  std::vector<T> array(const std::string& section, const std::string& name, int components) const {
    const auto end = head_.find("</" + section + ">");
    auto at = head_.find("<" + section + ">");
    REQUIRE(at != std::string::npos);
    while ((at = head_.find("<DataArray ", at + 1)) < end)
      if (attribute_at(at, "Name") == name) break;
    REQUIRE(at < end);
    CHECK(attribute_at(at, "NumberOfComponents") == std::to_string(components));
    CHECK(attribute_at(at, "type") == (std::is_floating_point_v<T> ? "Float64" : "Int64"));
    const auto offset = data_ + std::stoul(attribute_at(at, "offset"));
    std::uint64_t size = 0;
    std::memcpy(&size, bytes_.data() + offset, 8);
    REQUIRE(offset + 8 + size <= bytes_.size());
    std::vector<T> values(size / sizeof(T));
    if (size > 0) std::memcpy(values.data(), bytes_.data() + offset + 8, size);
    return values;
  }

 private:
  std::string bytes_;
  std::string head_;
  std::size_t data_ = 0;

  std::string attribute_at(std::size_t begin, const std::string& name) const {
    const auto value = head_.find(" " + name + "=\"", begin) + name.size() + 3;
    REQUIRE(value < head_.find('>', begin));
    return head_.substr(value, head_.find('"', value) - value);
  }
};

const std::vector<double> x{0, 1, 2}, y{3, 4, 5}, z{6, 7, 8};

}  // namespace

TEST_CASE("points and their fields are read back", "[io][vtk]") {
  const scratch::folder folder;
  const double tiny = std::numeric_limits<double>::denorm_min();
  io::write_points(folder / "p.vtp", x, y, z,
                   {{"radius", 1, {0.5, tiny, -0.0}}, io::vector_field("velocity <m/s> & \"more\"", z, y, x)});
  const parsed_vtp file{folder / "p.vtp"};
  CHECK(file.attribute("VTKFile", "type") == "PolyData");
  CHECK(file.attribute("VTKFile", "byte_order") == "LittleEndian");
  CHECK(file.attribute("VTKFile", "header_type") == "UInt64");
  CHECK(file.attribute("Piece", "NumberOfPoints") == "3");
  CHECK(file.attribute("Piece", "NumberOfVerts") == "3");
  CHECK(file.array<double>("Points", "Points", 3) == std::vector<double>{0, 3, 6, 1, 4, 7, 2, 5, 8});
  CHECK(file.array<double>("PointData", "radius", 1) == std::vector<double>{0.5, tiny, 0});
  CHECK(file.array<double>("PointData", "velocity &lt;m/s&gt; &amp; &quot;more&quot;", 3) ==
        std::vector<double>{6, 3, 0, 7, 4, 1, 8, 5, 2});
  CHECK(file.array<std::int64_t>("Verts", "connectivity", 1) == std::vector<std::int64_t>{0, 1, 2});
  CHECK(file.array<std::int64_t>("Verts", "offsets", 1) == std::vector<std::int64_t>{1, 2, 3});
  CHECK(folder.files() == 1);
}

TEST_CASE("lines and their fields are read back", "[io][vtk]") {
  const scratch::folder folder;
  const std::vector<std::array<std::int64_t, 2>> bridges{{0, 2}, {2, 1}};
  const std::vector<double> force{1e-6, 2e-6};
  io::write_lines(folder / "l.vtp", x, y, z, bridges, {{"id", 1, x}}, {{"force", 1, std::span{force}}});
  const parsed_vtp file{folder / "l.vtp"};
  CHECK(file.attribute("Piece", "NumberOfLines") == "2");
  CHECK(file.attribute("Piece", "NumberOfVerts") == "0");
  CHECK(file.array<std::int64_t>("Lines", "connectivity", 1) == std::vector<std::int64_t>{0, 2, 2, 1});
  CHECK(file.array<std::int64_t>("Lines", "offsets", 1) == std::vector<std::int64_t>{2, 4});
  CHECK(file.array<double>("PointData", "id", 1) == x);
  CHECK(file.array<double>("CellData", "force", 1) == force);
}

TEST_CASE("nothing is written as nothing", "[io][vtk]") {
  const scratch::folder folder;
  io::write_points(folder / "p.vtp", {}, {}, {});
  CHECK(parsed_vtp{folder / "p.vtp"}.array<double>("Points", "Points", 3).empty());
  io::write_lines(folder / "l.vtp", x, y, z, {}, {}, {{"force", 1, std::vector<double>{}}});
  CHECK(parsed_vtp{folder / "l.vtp"}.array<std::int64_t>("Lines", "offsets", 1).empty());
}

TEST_CASE("sizes that do not fit are refused before a file is touched", "[io][vtk]") {
  const scratch::folder folder;
  const auto said = [&](std::vector<io::field> fields, std::span<const double> heights) {
    return scratch::message<std::invalid_argument>([&] { io::write_points(folder / "p.vtp", x, y, heights, fields); });
  };
  CHECK(scratch::mentions(said({}, std::span{z}.first(2)), {"3, 3, 2", "equal"}));
  CHECK(scratch::mentions(said({{"speed", 1, {1, 2}}}, z), {"'speed'", "2 values", "3 are needed"}));
  CHECK(scratch::mentions(said({{"speed", 3, x}}, z), {"'speed'", "3 values", "9 are needed"}));
  CHECK(scratch::mentions(said({{"speed", 2, {1, 2, 3, 4, 5, 6}}}, z), {"'speed'", "2 components", "1", "3"}));
  CHECK(scratch::mentions(said({{"speed", 1, x}, {"speed", 1, y}}, z), {"two fields", "'speed'"}));
  for (const std::int64_t end : {-1, 3}) {
    const std::vector<std::array<std::int64_t, 2>> lines{{0, 1}, {end, 1}};
    CHECK(scratch::mentions(
        scratch::message<std::invalid_argument>([&] { io::write_lines(folder / "l.vtp", x, y, z, lines); }),
        {"line 1", "point " + std::to_string(end), "3 points"}));
  }
  CHECK(folder.files() == 0);
}
